// SPDX-License-Identifier: Apache-2.0
// Files that were exported, until the page has fetched them.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "meristem/base/whole_file.h"

namespace meristem::studio {

/// Keeps the files of the last exports in a folder of its own, which goes with it. Calls from any thread.
class Downloads {
 public:
  /// Removes the downloads that a killed studio has left.
  Downloads();
  /// An empty folder for the files of one export while they are made; it goes with its owner.
  using Draft = ScratchFolder;
  /// The downloads outlive their drafts. Throws MachineError.
  std::unique_ptr<Draft> begin();
  /// Keeps the files of a draft, which has no folder any more, and gives their number. The oldest files go where there
  /// are too many. Throws MachineError.
  std::uint64_t keep(const Draft& draft);
  /// The path of a file; nothing where there is none.
  std::optional<std::string> find(std::uint64_t number, const std::string& name) const;
  /// The folder of all files, or empty while there is none.
  std::string made_folder() const;

 private:
  const std::string& folder();

  mutable std::mutex mutex_;
  std::optional<ScratchFolder> folder_;  // once there is an export
  std::deque<std::uint64_t> kept_;
  std::uint64_t count_ = 0;
};

}  // namespace meristem::studio
