// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/whole_file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"

namespace meristem {

std::optional<std::string> whole_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream content;
  // An empty file puts nothing, which would make the stream fail.
  if (file.peek() != std::ifstream::traits_type::eof()) content << file.rdbuf();
  if (file.bad() || content.fail()) return std::nullopt;
  return std::move(content).str();
}

void write_whole_file(const std::string& path, std::string_view content) {
  AtomicFile file(path);
  file.write(content);
  file.commit();
}

void make_folders(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw MachineError(fmt::format("cannot make the folder '{}': {}", folder, error.message()));
}

ScratchFolder::ScratchFolder(const std::string& parent, std::string_view prefix) {
  make_folders(parent);
  std::string name = (std::filesystem::path(parent) / (std::string(prefix) + "XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw MachineError(fmt::format("cannot make a folder in '{}': {}", parent, std::strerror(errno)));
  }
  path_ = std::move(name);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace meristem
