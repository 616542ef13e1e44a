// SPDX-License-Identifier: Apache-2.0
#include "downloads.h"

#include <system_error>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/left_over.h"

namespace meristem::studio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxKept = 10;
constexpr const char* kFolderPrefix = "meristem-studio-";

}  // namespace

Downloads::Downloads() {
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  if (!error) remove_left_over_folders_once(temporary.string(), kFolderPrefix);
}

/// Returns the folder of all exports. Makes it for the first export.
const std::string& Downloads::folder() {
  if (!folder_) {
    std::error_code error;
    const fs::path temporary = fs::temp_directory_path(error);
    if (error) throw MachineError("cannot find a folder for exports: " + error.message());
    folder_.emplace(temporary.string(), kFolderPrefix);
  }
  return folder_->path();
}

std::unique_ptr<Downloads::Draft> Downloads::begin() {
  const std::lock_guard lock(mutex_);
  return std::make_unique<Draft>(folder(), "draft-");
}

std::uint64_t Downloads::keep(const Draft& draft) {
  const std::lock_guard lock(mutex_);
  const fs::path root(folder());
  std::error_code error;
  if (kept_.size() == kMaxKept) {
    fs::remove_all(root / std::to_string(kept_.front()), error);
    kept_.pop_front();
  }
  fs::rename(draft.path(), root / std::to_string(count_ + 1), error);
  if (error) throw MachineError(fmt::format("cannot keep an export: {}", error.message()));
  kept_.push_back(++count_);
  return count_;
}

std::string Downloads::made_folder() const {
  const std::lock_guard lock(mutex_);
  return folder_ ? folder_->path() : std::string();
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
