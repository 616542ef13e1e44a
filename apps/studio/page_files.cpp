// SPDX-License-Identifier: Apache-2.0
// Reads the pack of pack_page: for each file a line "NAME BYTES COMPRESSED\n" and its bytes.
#include "page_files.h"

#include <charconv>
#include <cstddef>
#include <map>

extern "C" {
extern const char meristem_studio_pack[];      // NOLINT(modernize-avoid-c-arrays): the assembler's
extern const char meristem_studio_pack_end[];  // NOLINT(modernize-avoid-c-arrays)
}

asm(".section .rodata\n"
    ".global meristem_studio_pack\n"
    ".global meristem_studio_pack_end\n"
    "meristem_studio_pack:\n"
    ".incbin \"" MERISTEM_STUDIO_PACK
    "\"\n"
    "meristem_studio_pack_end:\n"
    ".byte 0\n"
    ".text\n");

namespace meristem::studio {

namespace {

using Files = std::map<std::string_view, PageFile>;

Files read_pack(std::string_view pack) {
  Files files;
  while (!pack.empty()) {
    const std::string_view line = pack.substr(0, pack.find('\n'));
    const std::size_t first = line.find(' ');
    const std::size_t second = line.find(' ', first + 1);
    std::size_t size = 0;
    std::from_chars(line.data() + first + 1, line.data() + second, size);
    files[line.substr(0, first)] = {pack.substr(line.size() + 1, size), line.substr(second + 1) == "1"};
    pack.remove_prefix(line.size() + 1 + size);
  }
  return files;
}

const Files& files() {
  static const Files files =
      read_pack({meristem_studio_pack, static_cast<std::size_t>(meristem_studio_pack_end - meristem_studio_pack)});
  return files;
}

}  // namespace

std::optional<PageFile> page_file(std::string_view name) {
  const auto found = files().find(name);
  return found == files().end() ? std::nullopt : std::optional(found->second);
}

bool has_page() { return files().contains("index.html"); }

bool has_model_picture(const std::string& model) { return files().contains("pictures/" + model + ".jpg"); }

}  // namespace meristem::studio
