// SPDX-License-Identifier: Apache-2.0
// Reads and writes the program's own files as a whole. Files that an input names are read with read_file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace meristem {

/// Returns the content of a file, which may be empty. Returns nothing if the file cannot be read.
std::optional<std::string> whole_file(const std::string& path);

/// Writes a file completely or not at all (see AtomicFile). Replaces an existing file; "-" is standard output. The
/// folder of the file must exist. Throws MachineError.
void write_whole_file(const std::string& path, std::string_view content);

/// Creates a folder and its missing parents. Throws MachineError.
void make_folders(const std::string& folder);

/// A new private folder that is removed with this object. The folder of a killed process stays until the next program
/// creates a folder with an equal prefix in the same parent.
class ScratchFolder {
 public:
  /// Creates the folder in `parent`, which is created if missing. The name is `prefix`, the process id and random
  /// letters. Throws MachineError.
  ScratchFolder(const std::string& parent, std::string_view prefix);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// The path of the folder.
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int lock_ = -1;  // descriptor of the folder, see lock_temporary
};

}  // namespace meristem
