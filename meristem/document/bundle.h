// SPDX-License-Identifier: Apache-2.0
// Documents with the contents of all files that they name, so that another machine can grow them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meristem/document/document.h"

namespace meristem {

/// A document and the files that were read with it. Below one folder, the files keep their positions relative to each
/// other.
struct DocumentBundle {
  std::string document;  ///< path of the document's file below the folder
  /// Path below the folder and content of each file, including the document, sorted by path.
  std::vector<std::pair<std::string, std::string>> files;

  /// Hash of all paths and contents as 32 hexadecimal digits.
  std::string hash() const;
};

/// Makes the bundle of a document that was read. `models` is the folder of shipped models. Models are part of the
/// program and left out, unless the document itself is one. Files with absolute paths in the text are left out too,
/// because another machine would not find them in the bundle. Throws MachineError for files that can no longer be read.
DocumentBundle bundle_of(const Document& document, const std::string& models = {});

/// Writes the files below `folder`, which is created if necessary. Existing files with equal content are not changed.
/// Throws MachineError.
void unpack(const DocumentBundle& bundle, const std::string& folder);

}  // namespace meristem
