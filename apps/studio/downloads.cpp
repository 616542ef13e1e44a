// SPDX-License-Identifier: Apache-2.0
#include "downloads.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"

namespace meristem::studio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostKept = 10;

}  // namespace

Downloads::Downloads() = default;

Downloads::~Downloads() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

Downloads::Draft::~Draft() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void Downloads::require_folder() {
  if (!folder_.empty()) return;
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "meristem-studio-XXXXXX").string();
  if (error || ::mkdtemp(name.data()) == nullptr)  // readable by this user alone
    throw MachineError(fmt::format("cannot make a folder for exports: {}", std::strerror(errno)));
  folder_ = name;
}

std::unique_ptr<Downloads::Draft> Downloads::begin() {
  const std::lock_guard lock(mutex_);
  require_folder();
  const fs::path path = folder_ / fmt::format("draft-{}", ++drafts_);
  std::error_code error;
  if (!fs::create_directory(path, error)) throw MachineError("cannot make a folder for an export");
  return std::make_unique<Draft>(path);
}

std::uint64_t Downloads::keep(const Draft& draft) {
  const std::lock_guard lock(mutex_);
  std::error_code error;
  if (kept_.size() == kMostKept) {
    fs::remove_all(folder_ / std::to_string(kept_.front()), error);
    kept_.pop_front();
  }
  fs::rename(draft.path(), folder_ / std::to_string(count_ + 1), error);
  if (error) throw MachineError(fmt::format("cannot keep an export: {}", error.message()));
  kept_.push_back(++count_);
  return count_;
}

std::optional<std::string> Downloads::find(std::uint64_t number, const std::string& name) const {
  const std::lock_guard lock(mutex_);
  if (folder_.empty() || name.empty() || name[0] == '.' || name.find('/') != std::string::npos) return std::nullopt;
  const fs::path path = folder_ / std::to_string(number) / name;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  return path.string();
}

}  // namespace meristem::studio
