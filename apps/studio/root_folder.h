// SPDX-License-Identifier: Apache-2.0
// The one folder below which a studio reads and writes.
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

/// All paths are relative to the folder, with '/' between names. What leads out of it, by dots, from '/' on or over
/// links, and hidden names are refused without a word of what is there.
class RootFolder {
 public:
  /// Throws MachineError where there is no such folder.
  explicit RootFolder(const std::string& path);

  const std::string& path() const { return path_; }
  std::string name() const;
  /// The absolute path of a file below it. Throws a Refusal.
  std::string absolute(const std::string& relative) const;
  /// The path of an absolute path from this folder, if it lies below it, else nothing.
  std::optional<std::string> relative(const std::string& absolute) const;

  /// What is in a folder, by name; hidden ones and what is neither file nor folder are left out. Throws a Refusal.
  std::vector<FolderEntry> list(const std::string& folder) const;
  /// Returns a document's text. Throws an InputError with line and column if the file is not UTF-8, also Refusal and
  /// MachineError.
  std::string read(const std::string& file) const;
  /// Returns the hash of a file as it is on the disk. Returns nothing if there is none, and an empty text if the file
  /// is empty or too large to be a document. Throws Refusal, MachineError.
  std::optional<std::string> hash_on_disk(const std::string& file) const;
  /// Writes a document: all of it or nothing. `known` is the hash of what is thought to be there, null for a new file;
  /// unless `over`, a Refusal with "changed" where that is not so. Throws Refusal, MachineError.
  void write(const std::string& file, const std::string& text, const std::optional<std::string>& known,
             bool over) const;
  /// Writes a new file, whole or not at all, and makes the folders above it. Returns false, and writes nothing, if
  /// there is a file with this content. Throws a Refusal if something else is there, also Refusal and MachineError.
  bool add_file(const std::string& file, const std::string& content) const;

 private:
  std::string path_;
};

}  // namespace meristem::studio
