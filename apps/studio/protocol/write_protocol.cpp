// SPDX-License-Identifier: Apache-2.0
// Writes what is made from the description of the protocol, and checks recorded sessions:
//
//   meristem_studio_protocol --write FOLDER   writes protocol.md and the types of the page below apps/studio
//   meristem_studio_protocol --check FILE     compares recorded messages with the description, one JSON object per line
//
// --check prints each message that is not as described, and then the names of all requests that were answered.
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/read_file.h"
#include "meristem/document/json.h"
#include "protocol/conversation.h"
#include "protocol/markdown.h"
#include "protocol/typescript.h"
#include "refusal.h"

namespace meristem::studio {

namespace {

constexpr std::uint64_t kMaxPageBytes = 10'000'000;

void write(const std::string& path, const std::string& text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

int write_all(const std::string& folder) {
  const std::string page = folder + "/protocol.md";
  const std::string text = read_file(page, kMaxPageBytes);
  const std::size_t begin = text.find(kReferenceBegin);
  if (begin == std::string::npos) throw MachineError(page + " does not say where the reference begins");
  write(page, text.substr(0, begin) + kReferenceBegin + protocol_reference());
  for (const PageSource& file : typescript_files()) write(folder + "/page/src/server/types/" + file.name, file.text);
  return 0;
}

int check_all(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw MachineError("cannot read " + path);
  Conversation conversation;
  int line_number = 0;
  int errors = 0;
  for (std::string line; std::getline(file, line);) {
    ++line_number;
    try {
      conversation.take(parse_json(line));
    } catch (const std::exception& error) {
      fmt::print("{}:{}: {}\n", path, line_number, error.what());
      ++errors;
    }
  }
  for (const std::string& name : conversation.answered()) fmt::print("answered {}\n", name);
  return errors == 0 ? 0 : 1;
}

}  // namespace

}  // namespace meristem::studio

int main(int argc, char** argv) {
  try {
    const std::string what = argc == 3 ? argv[1] : "";
    if (what == "--write") return meristem::studio::write_all(argv[2]);
    if (what == "--check") return meristem::studio::check_all(argv[2]);
    throw meristem::MachineError("usage: meristem_studio_protocol --write FOLDER | --check FILE");
  } catch (const std::exception& error) {
    fmt::print(stderr, "meristem_studio_protocol: {}\n", error.what());
    return 1;
  }
}
