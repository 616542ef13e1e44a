// SPDX-License-Identifier: Apache-2.0
#include "tests/support/shared_data.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace meristem {

std::optional<std::string> find_shared_data(const std::string& name) {
  const char* const folder = std::getenv("MERISTEM_SHARED_DATA");
  const std::filesystem::path path = std::filesystem::path(folder != nullptr ? folder : MERISTEM_SHARED_DATA) / name;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  return path.string();
}

}  // namespace meristem
