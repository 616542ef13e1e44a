// SPDX-License-Identifier: Apache-2.0
// Reads and writes whole files, and creates scratch folders. A scratch folder has a random name and a lock, so that the
// next program can recognise and remove it if this process is killed.
#include "meristem/base/whole_file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/left_over.h"

namespace meristem {

std::optional<std::string> whole_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream content;
  // An empty file writes nothing, which would set the stream's error flag.
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
  remove_left_over_folders_once(parent, prefix);
  constexpr int kTries = 100;  // another process may remove the folder before it is locked
  for (int k = 0; k < kTries && path_.empty(); ++k) {
    std::string name = (std::filesystem::path(parent) / fmt::format("{}{}-XXXXXX", prefix, ::getpid())).string();
    if (::mkdtemp(name.data()) == nullptr) break;
    lock_ = ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock_ < 0) {
      if (errno == ENOENT) continue;  // another process has removed it already
      const int reason = errno;
      ::rmdir(name.c_str());
      errno = reason;
      break;
    }
    if (!lock_temporary(lock_)) {
      ::close(std::exchange(lock_, -1));
      continue;
    }
    path_ = std::move(name);
  }
  if (path_.empty()) {
    throw MachineError(fmt::format("cannot make a folder in '{}': {}", parent, std::strerror(errno)));
  }
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace meristem
