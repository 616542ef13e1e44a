// SPDX-License-Identifier: Apache-2.0
// Reads a file that an input names. The checks run before the file is opened: existence, kind, and size against the
// limit.
#include "meristem/base/read_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"
#include "meristem/base/reading_stop.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBytesAtOnce = 4'000'000;  // between two checks for a stop

std::string nearest_file(const fs::path& path) {
  constexpr std::size_t kMaxNames = 10'000;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end && names.size() < kMaxNames;
       entry.increment(error)) {
    names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  const std::string nearest = nearest_name(path.filename().string(), names);
  return nearest.empty() ? nearest : (path.parent_path() / nearest).string();
}

[[noreturn]] void throw_error(const std::string& path, std::string message, std::string expected,
                              std::string nearest = {}) {
  throw InputError(Diagnostic{
      .message = std::move(message), .expected = std::move(expected), .nearest = std::move(nearest), .file = path});
}

[[noreturn]] void throw_unreadable(const std::string& path) {
  throw MachineError(fmt::format("cannot read '{}': {}", path, std::generic_category().message(errno)));
}

}  // namespace

std::string read_file(const std::string& path, std::uint64_t max_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (path.empty() || path.find('\0') != std::string::npos || status.type() == fs::file_type::not_found) {
    const std::string nearest = nearest_file(path);
    throw_error(path, "there is no such file", nearest.empty() ? "the path of a file" : "", nearest);
  }
  if (fs::is_directory(status)) throw_error(path, "this is a folder", "a file");
  if (!fs::is_regular_file(status)) throw_error(path, "this is not a regular file", "a file on a disk");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) {
    errno = error.value();
    throw_unreadable(path);
  }
  if (size == 0) throw_error(path, "the file is empty", "");
  if (size > max_bytes) {
    Diagnostic diagnostic = limit_diagnostic("bytes of a file", static_cast<double>(size), max_bytes, "file_bytes", "");
    diagnostic.file = path;
    throw InputError(std::move(diagnostic));
  }

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (file == nullptr) throw_unreadable(path);
  std::string bytes(size, '\0');
  std::size_t read = 0;
  while (read < bytes.size()) {
    ReadingStop::check();
    const std::size_t part =
        std::fread(bytes.data() + read, 1, std::min(kBytesAtOnce, bytes.size() - read), file.get());
    if (part == 0) break;
    read += part;
  }
  bytes.resize(read);
  if (std::ferror(file.get()) != 0) throw_unreadable(path);
  return bytes;
}

}  // namespace meristem
