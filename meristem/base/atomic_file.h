// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace meristem {

/// A file that appears whole or not at all: bytes stream into a temporary file beside the target, and `commit()` renames
/// it into place. Destroyed without commit (an exception, a cancel), the temporary file is removed and a file that stood
/// there before is untouched. Path "-" streams to standard output instead, where nothing can be taken back.
/// Every failure (refused path, full disk) throws MachineError with the path and the reason.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(const void* data, std::size_t size);
  template <class T>
  void write(std::span<const T> values) {
    write(values.data(), values.size_bytes());
  }
  std::size_t size() const { return size_; }  ///< bytes written so far
  void commit();

 private:
  void flush();
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  std::string temporary_;  // empty for standard output and once renamed
  int descriptor_ = -1;
  std::size_t size_ = 0;
  std::vector<std::byte> buffer_;
};

}  // namespace meristem
