// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "meristem/document/document.h"

namespace meristem {

std::string read_text_file(const std::string& path, std::uint64_t document_bytes) {
  const bool is_input = path == "-";
  const std::string shown = is_input ? "<standard input>" : path;
  const auto fail = [&] {
    const std::string reason = std::generic_category().message(errno);
    throw MachineError(is_input ? fmt::format("cannot read standard input: {}", reason)
                                : fmt::format("cannot read '{}': {}", path, reason));
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> opened(is_input ? nullptr : std::fopen(path.c_str(), "rb"),
                                                               std::fclose);
  std::FILE* const file = is_input ? stdin : opened.get();
  if (file == nullptr) fail();
  std::string text;
  constexpr std::size_t kPiece = 1 << 16;
  for (;;) {
    const std::size_t before = text.size();
    text.resize(before + kPiece);
    errno = 0;
    const std::size_t got = std::fread(text.data() + before, 1, kPiece, file);
    text.resize(before + got);
    if (std::ferror(file) != 0) fail();
    if (text.size() > document_bytes) {
      Diagnostic diagnostic{.message = fmt::format("the document is larger than {} bytes", document_bytes),
                            .expected = "a smaller document",
                            .file = shown};
      throw InputError(std::move(diagnostic));
    }
    if (got < kPiece) return text;
  }
}

}  // namespace meristem
