// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "meristem/document/document.h"

namespace meristem {

std::string read_text_file(const std::string& path) {
  const Limits limits;
  const auto fail = [&path] { throw MachineError(fmt::format("cannot read '{}': {}", path, std::strerror(errno))); };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) fail();
  std::string text;
  constexpr std::size_t kPiece = 1 << 16;
  for (;;) {
    const std::size_t before = text.size();
    text.resize(before + kPiece);
    errno = 0;
    const std::size_t got = std::fread(text.data() + before, 1, kPiece, file.get());
    text.resize(before + got);
    if (std::ferror(file.get()) != 0) fail();
    if (text.size() > limits.document_bytes) {
      Diagnostic diagnostic{.message = fmt::format("the document is larger than {} bytes", limits.document_bytes),
                            .expected = "a smaller document",
                            .file = path};
      throw InputError(std::move(diagnostic));
    }
    if (got < kPiece) return text;
  }
}

}  // namespace meristem
