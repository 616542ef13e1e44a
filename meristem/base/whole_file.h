// SPDX-License-Identifier: Apache-2.0
// Files of a program's own, whole in memory. What an input names, read_file reads.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace meristem {

/// The bytes of a file, which may be none; nothing where it cannot be read.
std::optional<std::string> whole_file(const std::string& path);

/// Writes a file: whole, or not at all. Throws MachineError.
void write_whole_file(const std::string& path, std::string_view content);

/// Makes a folder and those above it, where they are not there. Throws MachineError.
void make_folders(const std::string& folder);

/// A new folder that nobody else reads, which goes with its owner. The folder of a killed process stays until the next
/// program makes a folder with the same prefix in the same parent.
class ScratchFolder {
 public:
  /// In `parent`, which is made, with a name of `prefix`, process id and random letters. Throws MachineError.
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
