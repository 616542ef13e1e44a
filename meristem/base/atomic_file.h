// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meristem {

/// A file that appears whole or not at all: bytes stream into a temporary file beside the target, and `commit()`
/// renames it into place. A killed process leaves its temporary file; the next program that writes into the folder
/// removes it. Destroyed without commit (an exception, a cancel), the temporary file is removed and a file
/// that stood there before is untouched. A target that is a symbolic link keeps the link; one that exists keeps its
/// permissions. Path "-" (or "/dev/stdout") streams to standard output instead, and a device or pipe is written
/// straight through; there nothing can be taken back. Every failure (refused path, full disk) throws MachineError with
/// the path and the reason.
class AtomicFile {
 public:
  /// Opens the temporary file beside `path`, or standard output for "-". Throws MachineError.
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends `size` bytes. Throws MachineError, for example when the disk is full, and std::invalid_argument after
  /// commit().
  void write(const void* data, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }
  template <class T>
  void write(std::span<const T> values) {
    write(values.data(), values.size_bytes());
  }
  std::size_t size() const { return size_; }  ///< bytes written so far
  /// Writes over bytes that have been written already, such as a count at the beginning that is known at the end. Not
  /// for streams, nor beyond size(): std::invalid_argument.
  void overwrite(std::size_t offset, std::string_view bytes);
  /// Reads back what has been written so far. Returns true if it is `bytes`. Not for streams: std::invalid_argument.
  bool holds(std::string_view bytes);
  /// True where bytes go straight through and nothing can be taken back.
  bool is_stream() const { return temporary_.empty(); }
  /// Puts the file in place, or hands it to this thread's FileSet; closes it first if it is open. Later calls throw
  /// std::invalid_argument, also after a failure.
  void commit();

 private:
  void open_temporary();
  void flush();
  void send_at(std::size_t offset, std::string_view bytes);
  void close();
  void send(const std::byte* data, std::size_t size);
  void close_descriptor();
  void close_lock();
  [[noreturn]] void fail();

  std::string path_;       // as the user wrote it
  std::string target_;     // path_ with links followed
  std::string temporary_;  // empty where bytes go straight through, and once renamed
  int descriptor_ = -1;
  int lock_ = -1;  // keeps the lock on the temporary file between closing and renaming
  std::size_t size_ = 0;
  std::vector<std::byte> buffer_;
};

/// Files that appear together or not at all: while it lives, each file that this thread commits waits whole beside its
/// target, and `commit()` renames them all. Destroyed without commit (an exception, a cancel), it removes what waits,
/// and the files that stood there before are untouched. Only a rename that the system refuses, or a power cut between
/// two, can leave some new and some old. Sets nest: an inner one hands its files to the outer one. Sets of one thread
/// end in the reverse order of their making.
class FileSet {
 public:
  /// Begins a set for the files of this thread.
  FileSet();
  ~FileSet();
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;

  /// Renames the files in the order in which they were committed. Throws MachineError for the first that is refused.
  void commit();

 private:
  friend class AtomicFile;
  struct Waiting {
    std::string temporary;
    std::string target;
    std::string path;  // as the user wrote it
    int lock = -1;     // descriptor that keeps the lock on `temporary`
  };
  static void unlock(const Waiting& file);

  FileSet* outer_;
  std::deque<Waiting> waiting_;
};

}  // namespace meristem
