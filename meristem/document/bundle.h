// SPDX-License-Identifier: Apache-2.0
// Documents with all files that they name, by content: what another machine needs to grow them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meristem/document/document.h"

namespace meristem {

/// A document and the files that were read with it, laid out below one folder as they lay to each other.
struct DocumentBundle {
  std::string document;  ///< path of the document's file below the folder
  /// Path below the folder and content of each file, the document's own among them, by path.
  std::vector<std::pair<std::string, std::string>> files;

  /// Hash of all paths and contents as 32 hexadecimal digits.
  std::string hash() const;
};

/// Bundles a document that was read. `models` is the folder of shipped models: those are part of the program, so they
/// are not taken along, unless the document itself is one. Files that the text names by absolute paths are not taken
/// along either, as they would not be sought elsewhere. Throws MachineError for files that cannot be read any more.
DocumentBundle bundle_of(const Document& document, const std::string& models = {});

/// Writes the files below `folder`, which is made. Files that are there with the same content stay as they are. Throws
/// MachineError.
void unpack(const DocumentBundle& bundle, const std::string& folder);

}  // namespace meristem
