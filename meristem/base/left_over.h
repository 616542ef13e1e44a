// SPDX-License-Identifier: Apache-2.0
// Temporary files and folders that killed programs leave behind. Each living owner holds a lock on its files, and the
// system releases the lock when the process ends in any way. The next program can therefore remove everything without a
// lock.
#pragma once

#include <string>
#include <string_view>

namespace meristem {

/// Locks a temporary file or folder until the descriptor and all copies of it are closed. Returns false if another
/// process removes it at this moment: the owner must then choose another name. Returns true on file systems without
/// locks.
bool lock_temporary(int descriptor);

/// The treatment of temporary files on a file system without locks, where programs cannot know whether an owner lives.
enum class WithoutLocks { keep, remove };

/// Removes a temporary file, or a folder with its content. Keeps it if a living process holds its lock or if it belongs
/// to another user. Returns true if it is gone.
bool remove_left_over(const std::string& path, WithoutLocks without_locks = WithoutLocks::keep);

/// Returns the name of a temporary file of this process for a target of this name: ".oak.glb.4711-0.part".
std::string temporary_name(std::string_view target, unsigned number);
/// Returns true for names that temporary_name can return.
bool is_temporary_name(std::string_view name);

/// Removes the temporary files of killed programs in a folder (not below it). Reads each folder once per process.
void remove_left_over_files_once(const std::string& folder);
/// Removes the folders of killed programs in `parent` whose names are `prefix`, a process id, "-" and six characters.
/// Reads each parent once per process and prefix.
void remove_left_over_folders_once(const std::string& parent, std::string_view prefix);

}  // namespace meristem
