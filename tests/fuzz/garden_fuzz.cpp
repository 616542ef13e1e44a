// SPDX-License-Identifier: Apache-2.0
// Fuzzes gardens: a document that may place the document "other.json" and read the table "table.csv". The three texts
// are separated by lines of '='. The result must be errors, each with a message and a file, or a small garden that
// grows.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

#include "meristem/base/parallel.h"
#include "meristem/base/progress.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "tests/fuzz/require.h"

namespace {

using namespace meristem;

/// Returns a folder of this process in memory.
const std::string& folder() {
  static const std::string kFolder = [] {
    const std::string path = "/dev/shm/garden_fuzz_" + std::to_string(getpid());
    std::filesystem::create_directories(path);
    return path;
  }();
  return kFolder;
}

/// Removes the text up to the next line of '=' and returns it.
std::string_view next_part(std::string_view& text) {
  constexpr std::string_view kLine = "\n=\n";
  const std::size_t end = text.find(kLine);
  const std::string_view part = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view() : text.substr(end + kLine.size());
  return part;
}

void write(const std::string& name, std::string_view text) {
  std::ofstream(folder() + "/" + name, std::ios::binary) << text;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer requires this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::string garden(next_part(text));
  write("garden.json", garden);
  write("other.json", next_part(text));
  write("table.csv", next_part(text));
  // Use small limits, so that one run takes milliseconds.
  ReadOptions options{.overrides = {{"limits.points", 500},
                                    {"limits.nodes", 2000},
                                    {"limits.instances", 300},
                                    {"limits.triangles", 20e3},
                                    {"limits.mesh_bytes", 4'000'000}},
                      .root = folder()};
  try {
    const Document document = read_document(garden, folder() + "/garden.json", builtin_components(), options);
    const ThreadLimit one_thread(1);
    Progress progress;
    grow_document(document, progress, {.up_to = GrownPart::plant});
  } catch (const InputError& error) {
    require(!error.diagnostics().empty());
    for (const Diagnostic& diagnostic : error.diagnostics()) {
      require(!diagnostic.message.empty());
      require(diagnostic.file.starts_with(folder()) || diagnostic.file.starts_with("--set ") ||
              diagnostic.file.starts_with("set "));
    }
  }
  return 0;
}
