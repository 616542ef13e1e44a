// SPDX-License-Identifier: Apache-2.0
#include "downloads.h"

#include <system_error>

#include "meristem/base/diagnostic.h"

namespace meristem::studio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostKept = 10;

}  // namespace

Downloads::Folder Downloads::add() {
  const std::lock_guard lock(mutex_);
  std::error_code error;
  if (!folder_) {
    const fs::path temporary = fs::temp_directory_path(error);
    if (error) throw MachineError("cannot find a folder for exports: " + error.message());
    folder_.emplace(temporary.string(), "meristem-studio-");
  }
  const fs::path root(folder_->path());
  if (kept_.size() == kMostKept) {
    fs::remove_all(root / std::to_string(kept_.front()), error);
    kept_.pop_front();
  }
  const Folder folder{.number = ++count_, .path = root / std::to_string(count_)};
  if (!fs::create_directory(folder.path, error)) throw MachineError("cannot make a folder for an export");
  kept_.push_back(folder.number);
  return folder;
}

std::optional<std::string> Downloads::find(std::uint64_t number, const std::string& name) const {
  const std::lock_guard lock(mutex_);
  if (!folder_ || name.empty() || name[0] == '.' || name.find('/') != std::string::npos) return std::nullopt;
  const fs::path path = fs::path(folder_->path()) / std::to_string(number) / name;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  return path.string();
}

}  // namespace meristem::studio
