// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace meristem {

class PlantSources;
class ReadStore;

/// Where a document's files are sought, which may be read, and what earlier reads have made of them.
struct FileAccess {
  std::string folder{};        ///< paths start here, or where it is empty in the present folder
  std::string root{};          ///< nothing outside of this folder is read, wherever links lead; empty: anything may be
  ReadStore* store = nullptr;  ///< takes and gives what was read; may be null
  PlantSources* sources = nullptr;  ///< opens other documents; null: there are none

  /// Throws an InputError for a path outside of the root, which tells nothing of what is there.
  void require_within(const std::string& path) const;
};

/// A file that a document names.
struct NamedFile {
  std::string path;                     ///< full path
  std::optional<std::uint64_t> hash{};  ///< hash of the file's content, where a store knows it
  /// True if the path starts at the document's folder. False for absolute paths, for shipped models, and for all files
  /// that documents found in one of these ways name themselves.
  bool is_beside = true;
};

}  // namespace meristem
