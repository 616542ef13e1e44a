// SPDX-License-Identifier: Apache-2.0
// The files of the page and the models' pictures, as the build has put them into the program.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace meristem::studio {

struct PageFile {
  std::string_view bytes;
  bool is_compressed = false;  ///< by gzip
};

/// Nothing where there is none of that name.
std::optional<PageFile> page_file(std::string_view name);

/// Whether the program was built with a page.
bool has_page();

/// Whether there is a small picture of a shipped model.
bool has_model_picture(const std::string& model);

}  // namespace meristem::studio
