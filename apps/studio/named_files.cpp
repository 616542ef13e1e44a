// SPDX-License-Identifier: Apache-2.0
#include "named_files.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>

#include "meristem/base/diagnostic.h"
#include "meristem/base/read_file.h"
#include "meristem/graph/table/file_access.h"
#include "refusal.h"

namespace meristem::studio {

namespace {

namespace fs = std::filesystem;

/// Returns the files that must be copied with the document, by their paths relative to its folder. Links are not
/// followed, because the document's text does not contain their targets.
std::map<std::string, std::string> files_by_path(const Document& document) {
  const fs::path folder = fs::absolute(fs::path(document.source.file).parent_path() / ".").lexically_normal();
  std::map<std::string, std::string> files;
  for (const std::string& named : document.source.files_beside) {
    const fs::path relative = fs::absolute(named).lexically_normal().lexically_relative(folder);
    if (!relative.empty()) files.emplace(relative.generic_string(), named);
  }
  return files;
}

/// Returns the path, below the root, of a file that a document in `folder` names `relative`. Throws a Refusal if this
/// is outside of the root.
std::string path_below_root(const RootFolder& root, const std::string& folder, const std::string& relative) {
  const fs::path target = (fs::weakly_canonical(root.absolute(folder)) / relative).lexically_normal();
  const std::optional<std::string> path = root.relative(target.string());
  if (!path) throw Refusal("its place would be outside the folder that may be written");
  return *path;
}

}  // namespace

NamedFileCopies copy_named_files(const Document& document, const std::string& source_root, const RootFolder& root,
                                 const std::string& folder) {
  const SizeLimits& limits = document.graph.limits;
  const std::uint64_t max_bytes = std::max(limits.file_bytes, limits.document_bytes);
  NamedFileCopies copies;
  for (const auto& [relative, source] : files_by_path(document)) {
    try {
      const std::string target = path_below_root(root, folder, relative);
      if (std::error_code error; fs::equivalent(source, root.absolute(target), error)) continue;
      FileAccess{.root = source_root}.require_within(source);
      if (root.add_file(target, read_file(source, max_bytes))) copies.copied.push_back(relative);
    } catch (const std::exception& error) {
      copies.omitted.push_back({relative, error.what()});
    }
  }
  return copies;
}

}  // namespace meristem::studio
