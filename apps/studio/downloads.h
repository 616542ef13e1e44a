// SPDX-License-Identifier: Apache-2.0
// Exported files, which the page can fetch.
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

/// Keeps the files of the last exports in a folder of its own, which is removed with this object. May be called from
/// any thread.
class Downloads {
 public:
  /// Removes the downloads that a killed studio has left.
  Downloads();
  /// An empty folder for the files of one export while they are written. It is removed with its owner.
  using Draft = ScratchFolder;
  /// Begins a draft. The downloads must outlive their drafts. Throws MachineError.
  std::unique_ptr<Draft> begin();
  /// Keeps the files of a draft and returns their number. The draft's folder is then gone. Removes the oldest files if
  /// there are too many. Throws MachineError.
  std::uint64_t keep(const Draft& draft);
  /// Returns the path of a file, or nothing if it does not exist.
  std::optional<std::string> find(std::uint64_t number, const std::string& name) const;
  /// Returns the folder of all files, or an empty path before the first export.
  std::string made_folder() const;

 private:
  const std::string& folder();

  mutable std::mutex mutex_;
  std::optional<ScratchFolder> folder_;  // set from the first export on
  std::deque<std::uint64_t> kept_;
  std::uint64_t count_ = 0;
};

}  // namespace meristem::studio
