// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace meristem {

class PlantSources;
class ReadStore;

/// The folders from which a document may read files, and the stores of earlier reads.
struct FileAccess {
  std::string folder{};             ///< folder at which paths start; empty: the present folder
  std::string root{};               ///< folder that limits reading, even through links; empty: no limit
  ReadStore* store = nullptr;       ///< keeps results for later reads; may be null
  PlantSources* sources = nullptr;  ///< opens other documents; null: no documents can be opened

  /// Throws an InputError for a path outside of the root. The message does not disclose whether the file exists.
  void require_within(const std::string& path) const;
};

/// A file that a document names.
struct NamedFile {
  std::string path;                     ///< full path
  std::optional<std::uint64_t> hash{};  ///< hash of the file's content, if a store knows it
  /// True if the path starts at the document's folder. False for absolute paths, for shipped models, and for all files
  /// that such documents name.
  bool is_beside = true;
};

}  // namespace meristem
