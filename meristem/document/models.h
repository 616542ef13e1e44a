// SPDX-License-Identifier: Apache-2.0
// The shipped documents. Users name them without path and ending. Each program knows their folder.
#pragma once

#include <string>
#include <vector>

namespace meristem {

/// Returns the names of a folder's documents (files without `.json`), in alphabetical order. Returns an empty list if
/// the folder cannot be read.
std::vector<std::string> model_names(const std::string& folder);
/// Returns the names of the films: documents with an animation, in the subfolder `films`. They grow from nothing, so at
/// the time 0 there may be nothing to see. Otherwise like model_names().
std::vector<std::string> film_names(const std::string& folder);
/// Returns the path of the file of a model or film in the folder, which need not exist.
std::string model_path(const std::string& folder, const std::string& name);

/// Returns the file that a user means by `path`: the file at this path, or else the model of this name. A file takes
/// precedence over a model. Throws InputError with the nearest model if a plain name is neither; other paths are
/// returned unchanged.
std::string find_document(const std::string& path, const std::string& folder);

/// A document's file, and the folder that holds the files that it may name.
struct DocumentFile {
  std::string file;  ///< path of the document
  std::string root;  ///< for ReadOptions::root; empty: any file may be read
};

/// Like find_document(), but finds no file outside the folder `root`, even through links and dots. A shipped model and
/// the files beside it may still be read. For a file outside the root, the InputError does not depend on whether the
/// file exists. An empty root allows every file.
DocumentFile find_document_within(const std::string& path, const std::string& folder, const std::string& root);

}  // namespace meristem
