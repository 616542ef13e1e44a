// SPDX-License-Identifier: Apache-2.0
// Edits a document as an editor does, and writes it as edited.json. Ctrl-C stops the reading.
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/edit/session.h"

namespace {

constexpr std::uint64_t kMaxBytes = 100'000'000;  // of a text that this program reads

meristem::Progress reading;

void stop_reading(int) { reading.cancel(); }

void report(const meristem::Session& session) {
  std::printf("%s, %zu steps to undo\n", session.is_good() ? "good" : "faulty", session.undo_count());
  for (const meristem::Diagnostic& error : session.errors()) std::puts(error.text().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("Usage: edit_document DOCUMENT\n", stderr);
    return 2;
  }
  const std::string file = argv[1];
  const std::string folder = std::filesystem::absolute(file).parent_path().string();
  std::signal(SIGINT, stop_reading);
  try {
    // Check the document. No file outside its folder is read, and its text may be larger than 16 MB.
    const std::string text = meristem::read_text_file(file, kMaxBytes);
    const meristem::Document document =
        meristem::read_document(text, file, meristem::builtin_components(),
                                {.root = folder, .progress = &reading, .document_bytes = kMaxBytes});
    std::printf("%s has %zu variables\n", document.name.c_str(), document.variables.size());

    // Two edits are one step. The text changes only where it must, so comments and layout stay.
    meristem::Session session(text, file, meristem::builtin_components(), {.root = folder});
    session.edit({meristem::SetValue{"age", 12}, meristem::SetValue{"description", "A young oak."}}, &reading);
    report(session);

    // A user types: each key changes the text, and the text is read once, after the last key.
    for (const char key : std::string("// for the park")) {
      session.change_text({{session.text().size(), 0, std::string(1, key)}});
    }
    session.read(&reading);
    report(session);

    // Each key is a step of its own. The last one is taken back.
    session.undo(&reading);
    std::ofstream("edited.json") << session.text();
    return session.is_good() ? 0 : 1;
  } catch (const meristem::Cancelled&) {
    std::fputs("stopped\n", stderr);
    return 1;
  } catch (const meristem::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const meristem::MachineError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
