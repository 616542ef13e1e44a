// SPDX-License-Identifier: Apache-2.0
// The shipped documents, which users name without path and ending. Each program knows their folder.
#pragma once

#include <string>
#include <vector>

namespace meristem {

/// The names of a folder's documents (files without `.json`), in alphabetical order; none if it cannot be read.
std::vector<std::string> model_names(const std::string& folder);
/// Returns the path of a model's file in the folder, which need not exist.
std::string model_path(const std::string& folder, const std::string& name);

/// The file that a user means by `path`: that file, or the model of this name, after which a file of the same name goes
/// first. Throws InputError with the nearest model where a plain name is neither; other paths come back as they are.
std::string find_document(const std::string& path, const std::string& folder);

/// A document's file, and the folder that holds the files that it may name.
struct DocumentFile {
  std::string file;  ///< path of the document
  std::string root;  ///< for ReadOptions::root; empty: any file may be read
};

/// Like find_document(), but finds no file outside the folder `root`, wherever links and dots lead. A shipped model may
/// be read all the same, with the files beside it. Throws the same InputError for a file outside the root whether there
/// is one or not. An empty root allows every file.
DocumentFile find_document_within(const std::string& path, const std::string& folder, const std::string& root);

}  // namespace meristem
