// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/dataset_links.h"

#include <filesystem>
#include <optional>
#include <system_error>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/table/within_root.h"

namespace meristem {

namespace fs = std::filesystem;

void require_links_within(const std::string& folder, const std::string& root) {
  if (root.empty()) return;
  std::error_code error;
  std::optional<std::string> outside;  // first link by name, whatever the order of the file system
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error)) {
    if (!entry.is_symlink(error)) continue;
    const std::string path = entry.path().string();
    if (is_within_root(path, root) || is_within_root(path, folder)) continue;
    if (!outside || path < *outside) outside = path;
  }
  if (!outside) return;
  throw InputError(Diagnostic{.message = "this link leads outside the folder that may be read",
                              .expected = "a file in that folder",
                              .file = *outside});
}

}  // namespace meristem
