// SPDX-License-Identifier: Apache-2.0
#include "tests/support/test_data.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace meristem {

std::string project_file(const std::string& name) { return std::string(MERISTEM_PROJECT) + "/" + name; }

std::optional<std::string> find_shared_data(const std::string& name) {
  const char* const folder = std::getenv("MERISTEM_SHARED_DATA");
  const std::filesystem::path path = std::filesystem::path(folder != nullptr ? folder : MERISTEM_SHARED_DATA) / name;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  return path.string();
}

std::vector<std::string> data_files(const std::vector<std::string>& own, const std::vector<std::string>& published) {
  std::vector<std::string> files;
  for (const std::string& name : own) files.push_back(project_file(name));
  for (const std::string& name : published) {
    if (auto path = find_shared_data(name)) files.push_back(std::move(*path));
  }
  return files;
}

}  // namespace meristem
