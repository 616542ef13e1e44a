// SPDX-License-Identifier: Apache-2.0
// The folder to which a studio's reading and writing is limited.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meristem::studio {

struct FolderEntry {
  std::string name;
  bool is_folder = false;
  std::uint64_t bytes = 0;
};

/// All paths are relative to the folder, with '/' between names. Paths that lead out of it, by dots, by a leading '/'
/// or by links, and hidden names are refused. The refusal does not disclose what is there.
class RootFolder {
 public:
  /// Throws MachineError if the folder does not exist.
  explicit RootFolder(const std::string& path);

  const std::string& path() const { return path_; }
  std::string name() const;
  /// Returns the absolute path of a file below the folder. Throws a Refusal.
  std::string absolute(const std::string& relative) const;
  /// Returns the relative path of an absolute path below this folder, or nothing for other paths.
  std::optional<std::string> relative(const std::string& absolute) const;

  /// Returns the entries of a folder, sorted by name. Omits hidden entries and everything except files and folders.
  /// Throws a Refusal.
  std::vector<FolderEntry> list(const std::string& folder) const;
  /// Returns a document's text. Throws an InputError with line and column if the file is not UTF-8. Throws Refusal,
  /// MachineError.
  std::string read(const std::string& file) const;
  /// Returns the hash of a file on the disk. Returns nothing if the file does not exist, and an empty text if the file
  /// is empty or too large to be a document. Throws Refusal, MachineError.
  std::optional<std::string> hash_on_disk(const std::string& file) const;
  /// Writes a document, whole or not at all. `known` is the expected hash of the existing file, or nothing for a new
  /// file. If the file differs from this and `over` is false, throws a Refusal with "changed". Throws Refusal,
  /// MachineError.
  void write(const std::string& file, const std::string& text, const std::optional<std::string>& known,
             bool over) const;
  /// Writes a new file, whole or not at all, and makes the folders above it. If a file with this content exists,
  /// returns false and writes nothing. Throws a Refusal if something else exists there, and MachineError.
  bool add_file(const std::string& file, const std::string& content) const;

 private:
  std::string path_;
};

}  // namespace meristem::studio
