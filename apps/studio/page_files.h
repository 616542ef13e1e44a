// SPDX-License-Identifier: Apache-2.0
// The files of the page and the models' pictures, which the build has put into the program.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace meristem::studio {

struct PageFile {
  std::string_view bytes;
  bool is_compressed = false;  ///< by gzip
};

/// Returns the file with this name, or nothing if it does not exist.
std::optional<PageFile> page_file(std::string_view name);

/// Returns true if the program was built with a page.
bool has_page();

/// Returns true if a shipped model has a small picture.
bool has_model_picture(const std::string& model);

}  // namespace meristem::studio
