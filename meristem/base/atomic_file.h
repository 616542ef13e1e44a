// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meristem {

/// A file that appears complete or not at all. Bytes go into a temporary file beside the target, and `commit()` renames
/// it to the target. If the object is destroyed without commit (an exception, a cancel), the temporary file is removed,
/// and an earlier file at the target is unchanged. A killed process leaves its temporary file, and the next program
/// that writes into the folder removes it. A target that is a symbolic link stays a link, and an existing target keeps
/// its permissions. Path "-" (or "/dev/stdout") streams to standard output. Devices and pipes are written directly. In
/// both cases nothing can be undone. Every failure (refused path, full disk) throws MachineError with the path and the
/// reason.
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
  std::size_t size() const { return size_; }  ///< number of bytes written so far
  /// Overwrites bytes that were written before, such as a count at the beginning that is known only at the end. Throws
  /// std::invalid_argument for streams and beyond size().
  void overwrite(std::size_t offset, std::string_view bytes);
  /// Reads back everything that was written so far. Returns true if it equals `bytes`. Throws std::invalid_argument for
  /// streams.
  bool holds(std::string_view bytes);
  /// Returns true if bytes are written directly, so that nothing can be undone.
  bool is_stream() const { return temporary_.empty(); }
  /// Puts the file in place, or adds it to the FileSet of this thread. Closes the file first if it is open. Later calls
  /// throw std::invalid_argument, also after a failure.
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
  std::string temporary_;  // empty if bytes are written directly, and after the rename
  int descriptor_ = -1;
  int lock_ = -1;  // keeps the lock on the temporary file between close and rename
  std::size_t size_ = 0;
  std::vector<std::byte> buffer_;
};

/// Files that appear together or not at all. While the set exists, each file that this thread commits stays complete in
/// a temporary file beside its target. `commit()` renames all of them. If the set is destroyed without commit (an
/// exception, a cancel), it removes these files, and earlier files at the targets are unchanged. Only a refused rename,
/// or a power failure between two renames, can leave some new and some old files. Sets nest: an inner set passes its
/// files to the outer set. The sets of one thread must end in the reverse order of their construction.
class FileSet {
 public:
  /// Begins a set for the files of this thread.
  FileSet();
  ~FileSet();
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;

  /// Renames the files in the order in which they were committed. Throws MachineError for the first refused rename.
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
