// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/file_access.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/table/within_root.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

/// Returns the path without links and dots, up to its last existing part. Returns an empty path if this fails.
fs::path resolved(const std::string& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  if (error) return {};
  fs::path real = fs::weakly_canonical(absolute, error);
  // A link that leads nowhere is kept as it is, and its target is not disclosed.
  if (error || fs::is_symlink(fs::symlink_status(real, error))) return {};
  return real;
}

bool is_within(const fs::path& path, const fs::path& folder) {
  if (path.empty() || folder.empty()) return false;
  const auto [rest, ignored] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return rest == folder.end() || (rest->empty() && std::next(rest) == folder.end());  // "folder/" ends in an empty name
}

}  // namespace

bool is_within_root(const std::string& path, const std::string& root) {
  if (root.empty()) return true;
  const bool is_name = path.find('\0') == std::string::npos;
  return is_name && is_within(resolved(path), resolved(root));
}

void FileAccess::require_within(const std::string& path) const {
  if (is_within_root(path, root)) return;
  throw InputError(
      Diagnostic{.message = "this lies outside the folder that may be read", .expected = "a file in that folder"});
}

}  // namespace meristem
