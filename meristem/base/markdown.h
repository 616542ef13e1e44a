// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace meristem {

/// `text` for a cell of a table in Markdown: a bar of its own does not end the cell.
std::string markdown_cell(std::string_view text);

}  // namespace meristem
