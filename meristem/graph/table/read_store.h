// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <typeinfo>
#include <unordered_map>

#include "meristem/base/fingerprint.h"

namespace meristem {

/// Keeps expensive results of reading a document, such as the contents of files, by hashes of their sources. Later
/// reads of an unchanged or changed document reuse them. A file is read once: its content counts as unchanged until
/// reload(). Results that the last reads without faults did not use are removed. Only one read at a time may use the
/// store.
class ReadStore {
 public:
  /// Makes the next read check the size and time of all files, and read changed files again.
  void reload();

  /// Counts of the work of this store since its beginning.
  struct Counts {
    std::uint64_t files_read = 0;  ///< files whose content was read
    std::uint64_t made = 0;        ///< results that had to be made
    std::uint64_t reused = 0;      ///< results that were kept from earlier reads
  };
  const Counts& counts() const { return counts_; }  ///< counts since the beginning

  /// Begins a read.
  void begin_read() { ++read_; }
  /// Ends a read without faults.
  void end_read();

  /// Returns the hash of a file's content. Returns nothing if the file is not a plain file. Throws as read_file does.
  std::optional<std::uint64_t> file_hash(const std::string& path, std::uint64_t max_bytes);

  /// Returns the result that was kept under the key, or null.
  template <class T>
  std::shared_ptr<const T> find(std::uint64_t key) {
    return std::static_pointer_cast<const T>(find_any(key_of<T>(key)));
  }
  /// Keeps a result under a key.
  template <class T>
  void keep(std::uint64_t key, std::shared_ptr<const T> made) {
    keep_any(key_of<T>(key), std::move(made));
  }

 private:
  struct File {
    std::uint64_t size = 0;
    std::int64_t time = 0;
    std::uint64_t hash = 0;
    std::uint64_t read = 0;   // the last read that used it
    bool is_checked = false;  // whether it was checked since the last reload
  };
  struct Entry {
    std::shared_ptr<const void> made;
    std::uint64_t read = 0;
  };

  template <class T>
  static std::uint64_t key_of(std::uint64_t key) {
    return Fingerprint().add_text(typeid(T).name()).add(key).hash();
  }
  std::shared_ptr<const void> find_any(std::uint64_t key);
  void keep_any(std::uint64_t key, std::shared_ptr<const void> made);

  std::unordered_map<std::string, File> files_;
  std::unordered_map<std::uint64_t, Entry> entries_;
  std::uint64_t read_ = 0;
  Counts counts_;
};

}  // namespace meristem
