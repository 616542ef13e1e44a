// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace meristem {

/// Returns Markdown for the cell of a table: bars in the text do not end the cell. All other marks keep their meaning.
/// The text must have no line breaks, and no backslash before a bar.
std::string markdown_cell(std::string_view text);

/// Returns Markdown and HTML that shows `text` literally on one line, also in a cell of a table. For names, paths and
/// errors from documents. Marks, tags, links and entities lose their meaning. Line breaks and tabs become blanks, and
/// blanks at the beginning are removed. Control characters and marks that change the direction of text become visible:
/// `\u202E`.
std::string markdown_text(std::string_view text);

}  // namespace meristem
