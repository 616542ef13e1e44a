// SPDX-License-Identifier: Apache-2.0
// Removes temporary files and folders whose owners were killed. Names contain the process number, and a lock on the
// file shows whether the owner lives.
#include "meristem/base/left_over.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "meristem/base/function_ref.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKeptOfName = 200;   // bytes of the target's name that are kept, so that a suffix fits into the
                                           // limit of 255
constexpr std::size_t kRandomLetters = 6;  // number of random letters that mkdtemp appends
constexpr std::string_view kPart = ".part";

/// Removes `suffix` and the number before it from the end of `name`. Returns false if `name` does not end like this.
bool take_number_before(std::string_view& name, std::string_view suffix) {
  if (!name.ends_with(suffix)) return false;
  name.remove_suffix(suffix.size());
  const std::size_t before = name.size();
  while (!name.empty() && name.back() >= '0' && name.back() <= '9') name.remove_suffix(1);
  return name.size() < before;
}

/// Returns true if this is the name of a scratch folder with this prefix.
bool is_scratch_name(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || name.size() < prefix.size() + kRandomLetters + 2) return false;
  name.remove_prefix(prefix.size());
  name.remove_suffix(kRandomLetters);
  return take_number_before(name, "-") && name.empty();
}

/// Returns true for the first call of this process with the key.
bool is_first_call(const std::string& key) {
  static std::mutex mutex;
  static std::set<std::string> known;
  const std::scoped_lock lock(mutex);
  return known.insert(key).second;
}

/// Returns the process number in the name of a temporary file: "4711" in ".oak.glb.4711-0.part".
std::string process_in(const std::string& name) {
  const std::size_t dash = name.rfind('-');
  const std::size_t dot = name.rfind('.', dash);
  return name.substr(dot + 1, dash - dot - 1);
}

/// Returns true if another descriptor holds the lock of the file.
bool is_locked(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool is_free = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
  ::close(descriptor);
  return !is_free;
}

std::vector<std::string> entries_of(const std::string& folder,
                                    FunctionRef<bool(const std::string& name)> is_temporary) {
  std::vector<std::string> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (is_temporary(entry->path().filename().string())) found.push_back(entry->path().string());
  }
  return found;
}

}  // namespace

bool lock_temporary(int descriptor) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
  // Another process may have removed the file between its creation and the lock.
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

bool remove_left_over(const std::string& path, WithoutLocks without_locks) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return errno == ENOENT;
  const bool is_folder = S_ISDIR(status.st_mode);
  if ((!is_folder && !S_ISREG(status.st_mode)) || status.st_uid != ::geteuid()) return false;
  // Network file systems lock only files that are open for writing, and do not lock folders at all.
  const int access = is_folder ? O_RDONLY | O_DIRECTORY : O_WRONLY | O_NONBLOCK;
  const int descriptor = ::open(path.c_str(), access | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return errno == ENOENT;
  const bool has_lock = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  const bool is_free = has_lock || (errno != EWOULDBLOCK && without_locks == WithoutLocks::remove);
  std::error_code error;
  // The lock is held meanwhile, so an owner that has just created the file notices the removal.
  if (is_free) fs::remove_all(path, error);
  ::close(descriptor);
  return is_free && !error;
}

std::string temporary_name(std::string_view target, unsigned number) {
  return fmt::format(".{}.{}-{}{}", target.substr(0, kKeptOfName), ::getpid(), number, kPart);
}

bool is_temporary_name(std::string_view name) {
  return name.starts_with('.') && take_number_before(name, kPart) && take_number_before(name, "-") && name.size() > 1 &&
         name.ends_with('.');
}

void remove_left_over_files_once(const std::string& folder) {
  if (!is_first_call(folder)) return;
  const std::vector<std::string> found =
      entries_of(folder, [](const std::string& name) { return is_temporary_name(name); });
  // A set of many files keeps locks on the first files only, so one lock protects all files of its process.
  std::set<std::string> living;
  for (const std::string& path : found) {
    if (is_locked(path)) living.insert(process_in(fs::path(path).filename()));
  }
  for (const std::string& path : found) {
    if (!living.contains(process_in(fs::path(path).filename()))) remove_left_over(path);
  }
}

void remove_left_over_folders_once(const std::string& parent, std::string_view prefix) {
  if (!is_first_call(fmt::format("{}/{}", parent, prefix))) return;
  for (const std::string& path :
       entries_of(parent, [prefix](const std::string& name) { return is_scratch_name(name, prefix); })) {
    remove_left_over(path);
  }
}

}  // namespace meristem
