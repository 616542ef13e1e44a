// SPDX-License-Identifier: Apache-2.0
// Temporary files and folders that killed programs leave behind. Each living owner holds a lock on what it makes, and
// the system releases the lock when the process ends in any way. So the next program removes what has no lock.
#pragma once

#include <string>
#include <string_view>

namespace meristem {

/// Locks a temporary file or folder until the descriptor and all copies of it are closed. Returns false if another
/// process removes it at this moment: the owner must then choose another name. Returns true on file systems without
/// locks.
bool lock_temporary(int descriptor);

/// What happens to temporary things on a file system without locks, where nobody can tell whether an owner lives.
enum class WithoutLocks { keep, remove };

/// Removes a temporary file, or a folder with all that it holds, unless a living process holds its lock or it belongs
/// to another user. Returns whether it is gone.
bool remove_left_over(const std::string& path, WithoutLocks without_locks = WithoutLocks::keep);

/// The name of a temporary file of this process for a target of this name: ".oak.glb.4711-0.part".
std::string temporary_name(std::string_view target, unsigned number);
/// Returns true for names that temporary_name can give.
bool is_temporary_name(std::string_view name);

/// Removes the temporary files of killed programs in a folder (not below it). Reads each folder once per process.
void remove_left_over_files_once(const std::string& folder);
/// Removes the folders of killed programs in `parent` whose names are `prefix`, a process id, "-" and six characters.
/// Reads each parent once per process and prefix.
void remove_left_over_folders_once(const std::string& parent, std::string_view prefix);

}  // namespace meristem
