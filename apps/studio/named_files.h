// SPDX-License-Identifier: Apache-2.0
// Copies the files that a document names to the place where the document is saved.
#pragma once

#include <string>
#include <vector>

#include "meristem/document/document.h"
#include "root_folder.h"

namespace meristem::studio {

/// The result of `copy_named_files`. Paths start at the document's folder and use '/'.
struct NamedFileCopies {
  struct Omitted {
    std::string file;
    std::string reason;
  };
  std::vector<std::string> copied;  ///< in alphabetical order
  std::vector<Omitted> omitted;     ///< files that the document misses at its new place, or finds there changed
};

/// Copies the files that `document` finds by relative paths, so that the same paths find them from `folder`, a folder
/// below `root`. Shipped models and files that are named by absolute paths are found from everywhere, so they stay.
/// Each copy appears whole or not at all. A file that exists at the new place is never replaced: it is in `omitted`
/// if its content differs. Files that can be neither read within `source_root` nor written within `root` are in
/// `omitted`, too. Never throws for a file.
NamedFileCopies copy_named_files(const Document& document, const std::string& source_root, const RootFolder& root,
                                 const std::string& folder);

}  // namespace meristem::studio
