// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/read_store.h"

#include <filesystem>
#include <system_error>

#include "meristem/base/hash.h"
#include "meristem/base/read_file.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

// Number of reads for which an unused result is kept, so that an undo finds it
constexpr std::uint64_t kReadsKept = 16;

}  // namespace

void ReadStore::reload() {
  for (auto& [path, file] : files_) file.is_checked = false;
}

void ReadStore::end_read() {
  const auto is_old = [this](const auto& entry) { return entry.second.read + kReadsKept < read_; };
  std::erase_if(files_, is_old);
  std::erase_if(entries_, is_old);
}

std::optional<std::uint64_t> ReadStore::file_hash(const std::string& path, std::uint64_t max_bytes) {
  const auto known = files_.find(path);
  if (known != files_.end() && known->second.is_checked) {
    known->second.read = read_;
    return known->second.hash;
  }
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_regular_file(path, error)) return std::nullopt;
  File file{.read = read_, .is_checked = true};
  file.size = fs::file_size(path, error);
  file.time = fs::last_write_time(path, error).time_since_epoch().count();
  const bool is_same =
      known != files_.end() && !error && file.size == known->second.size && file.time == known->second.time;
  if (is_same) {
    file.hash = known->second.hash;
  } else {
    file.hash = hash64(read_file(path, max_bytes));
    ++counts_.files_read;
  }
  files_.insert_or_assign(path, file);
  return file.hash;
}

std::shared_ptr<const void> ReadStore::find_any(std::uint64_t key) {
  const auto found = entries_.find(key);
  if (found == entries_.end()) return nullptr;
  found->second.read = read_;
  ++counts_.reused;
  return found->second.made;
}

void ReadStore::keep_any(std::uint64_t key, std::shared_ptr<const void> made) {
  ++counts_.made;
  entries_.insert_or_assign(key, Entry{std::move(made), read_});
}

}  // namespace meristem
