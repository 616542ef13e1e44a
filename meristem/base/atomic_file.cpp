// SPDX-License-Identifier: Apache-2.0
// Writes files atomically: bytes go to a temporary file with a lock in the target's folder, and a rename puts the file
// in place. A set delays the renames of all files of a thread until all files are complete.
#include "meristem/base/atomic_file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/left_over.h"

namespace meristem {

namespace {

constexpr std::size_t kBufferBytes = 1 << 20;
constexpr int kMaxLinks = 40;  // the limit of the Linux kernel

/// Returns the path to which `path` leads if its last part is a symbolic link. The result need not exist. Returns an
/// empty path and sets `errno` for a loop of links or an empty path.
std::string without_links(std::string path) {
  if (path.empty()) errno = ENOENT;
  std::error_code error;
  for (int links = 0; std::filesystem::is_symlink(path, error); ++links) {
    if (links == kMaxLinks) {
      errno = ELOOP;
      return {};
    }
    const std::filesystem::path next = std::filesystem::read_symlink(path, error);
    if (error) break;
    path = std::filesystem::path(path).parent_path() / next;
  }
  return path;
}

/// Returns a hidden name in the target's directory that nobody else uses: `.oak.glb.4711-0.part`.
std::string temporary_beside(const std::string& target) {
  static std::atomic<unsigned> count{0};
  const std::size_t name_at = target.rfind('/') + 1;  // 0 if there is no slash
  return target.substr(0, name_at) + temporary_name(std::string_view(target).substr(name_at), count++);
}

/// A set keeps at most this many descriptors open, so that its program can open further files.
constexpr std::size_t kMaxLocksOfSet = 200;

[[noreturn]] void throw_cannot_write(const std::string& path, int reason) {
  const std::string where = path == "-" ? "standard output" : "'" + path + "'";
  throw MachineError(fmt::format("cannot write {}: {}", where, std::generic_category().message(reason)));
}

// The innermost set of this thread.
thread_local FileSet* current_set = nullptr;

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
  buffer_.reserve(kBufferBytes);
  if (path_ == "-" || path_ == "/dev/stdout") {
    descriptor_ = STDOUT_FILENO;
    return;
  }
  target_ = without_links(path_);
  struct stat status {};
  const bool exists = !target_.empty() && ::stat(target_.c_str(), &status) == 0;
  if (target_.empty() || (!exists && errno != ENOENT)) fail();
  if (exists && S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    fail();
  }
  // A device or pipe cannot be replaced, so write it directly. Do not retry after an interrupt: a pipe without a reader
  // blocks forever.
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail();
    return;
  }
  // A rename would also replace a read-only file, so check the permission here.
  if (exists && ::access(target_.c_str(), W_OK) != 0) fail();
  open_temporary();
  if (exists && ::fchmod(descriptor_, status.st_mode & 0777) != 0) {
    const int reason = errno;
    ::unlink(temporary_.c_str());
    errno = reason;
    fail();
  }
}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  close_descriptor();
  close_lock();
}

void AtomicFile::write(const void* data, std::size_t size) {
  if (descriptor_ < 0) throw std::invalid_argument("a file cannot be written to after its end");
  const auto* bytes = static_cast<const std::byte*>(data);
  size_ += size;
  if (buffer_.size() + size > kBufferBytes) flush();
  if (size >= kBufferBytes) return send(bytes, size);
  buffer_.insert(buffer_.end(), bytes, bytes + size);
}

void AtomicFile::overwrite(std::size_t offset, std::string_view bytes) {
  if (descriptor_ < 0 || is_stream() || offset + bytes.size() > size_) {
    throw std::invalid_argument("only what is in an open file can be written over");
  }
  flush();
  send_at(offset, bytes);
}

bool AtomicFile::holds(std::string_view bytes) {
  if (descriptor_ < 0 || is_stream()) throw std::invalid_argument("only an open file can be read back");
  flush();
  const int reader = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  if (reader < 0) fail();
  std::vector<char> piece(kBufferBytes);
  bool is_equal = true;
  for (;;) {
    const ssize_t got = ::read(reader, piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    const std::string_view there(piece.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
    is_equal = got >= 0 && bytes.substr(0, there.size()) == there;
    if (!is_equal || got == 0) break;
    bytes.remove_prefix(there.size());
  }
  ::close(reader);
  return is_equal && bytes.empty();
}

void AtomicFile::commit() {
  if (descriptor_ < 0) throw std::invalid_argument("a file can be committed only once");
  flush();
  if (!temporary_.empty()) lock_ = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
  close();
  if (temporary_.empty()) return;
  if (current_set != nullptr) {
    if (current_set->waiting_.size() >= kMaxLocksOfSet) close_lock();
    current_set->waiting_.push_back({temporary_, target_, path_, std::exchange(lock_, -1)});
  } else if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    fail();
  }
  close_lock();
  temporary_.clear();
}

void AtomicFile::open_temporary() {
  remove_left_over_files_once(target_.substr(0, target_.rfind('/') + 1));
  // A name is in use only if a process with this number was killed, on another machine or under another user.
  constexpr int kTries = 100;
  for (int k = 0; k < kTries && descriptor_ < 0; ++k) {
    temporary_ = temporary_beside(target_);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) break;
    if (descriptor_ >= 0 && !lock_temporary(descriptor_)) close_descriptor();
  }
  if (descriptor_ < 0) fail();
}

void AtomicFile::flush() {
  send(buffer_.data(), buffer_.size());
  buffer_.clear();
}

/// Network file systems report a full disk only at close.
void AtomicFile::close() {
  if (const int descriptor = std::exchange(descriptor_, -1); descriptor != STDOUT_FILENO && ::close(descriptor) != 0) {
    fail();
  }
}

void AtomicFile::send(const std::byte* data, std::size_t size) {
  while (size > 0) {
    const ssize_t sent = ::write(descriptor_, data, size);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) fail();
    data += sent;
    size -= static_cast<std::size_t>(sent);
  }
}

void AtomicFile::send_at(std::size_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) fail();
    offset += static_cast<std::size_t>(sent);
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

void AtomicFile::close_descriptor() {
  if (descriptor_ >= 0 && descriptor_ != STDOUT_FILENO) ::close(descriptor_);
  descriptor_ = -1;
}

void AtomicFile::close_lock() {
  if (lock_ >= 0) ::close(lock_);
  lock_ = -1;
}

/// Throws MachineError with the reason in `errno`. Later writes are refused.
void AtomicFile::fail() {
  const int reason = errno;
  close_descriptor();
  throw_cannot_write(path_, reason);
}

FileSet::FileSet() : outer_(std::exchange(current_set, this)) {}

FileSet::~FileSet() {
  current_set = outer_;
  for (const Waiting& file : waiting_) {
    ::unlink(file.temporary.c_str());
    unlock(file);
  }
}

void FileSet::unlock(const Waiting& file) {
  if (file.lock >= 0) ::close(file.lock);
}

void FileSet::commit() {
  if (outer_ != nullptr) {
    for (Waiting& file : waiting_) {
      if (outer_->waiting_.size() >= kMaxLocksOfSet && file.lock >= 0) ::close(std::exchange(file.lock, -1));
      outer_->waiting_.push_back(file);
    }
    waiting_.clear();
    return;
  }
  // The destructor removes the remaining files if a rename is refused.
  while (!waiting_.empty()) {
    if (std::rename(waiting_.front().temporary.c_str(), waiting_.front().target.c_str()) != 0) {
      throw_cannot_write(waiting_.front().path, errno);
    }
    unlock(waiting_.front());
    waiting_.pop_front();
  }
}

}  // namespace meristem
