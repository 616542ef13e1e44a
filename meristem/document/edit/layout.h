// SPDX-License-Identifier: Apache-2.0
// The layout of a JSON text: its lines, indentation and comments, and the form of a new value among them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/graph/table/value.h"

namespace meristem {

/// Largest length of a line. Longer lines are broken when something new is written.
inline constexpr std::size_t kLongestLine = 120;

/// Returns the first line end in the text, or "\n" if it has none.
std::string_view line_end_of(std::string_view text);
/// Returns one level of indentation, taken from the first indented line. Returns two spaces if no line is indented.
std::string_view indent_unit_of(std::string_view text);

/// Returns the beginning of the line of the byte at `offset`.
std::size_t line_begin(std::string_view text, std::size_t offset);
/// Returns the spaces at the beginning of this line.
std::string_view indent_at(std::string_view text, std::size_t offset);
/// Returns true if only spaces precede `offset` in its line.
bool begins_line(std::string_view text, std::size_t offset);
/// Returns true if only spaces follow in the line. `behind` is then set to the beginning of the next line, or to the
/// text's end.
bool ends_line(std::string_view text, std::size_t offset, std::size_t* behind = nullptr);
/// Returns the end of the comments that follow in the line and end in it. Returns `offset` if there are no comments.
std::size_t behind_comments(std::string_view text, std::size_t offset);

struct Comment {
  std::size_t begin = 0;
  std::size_t end = 0;  ///< for a comment with //, the end of its line
  bool to_line_end = false;
};
/// Returns the comments between two tokens.
std::vector<Comment> comments_between(std::string_view text, std::size_t begin, std::size_t end);

/// The position of a new value.
struct WritingPlace {
  std::string_view indent;  ///< indentation of the line
  std::string_view unit;
  std::string_view line_end;
  std::size_t column = 0;  ///< column in the line, bytes
};

/// Returns the value on one line if it fits. Otherwise each member has its own line, and lists without objects fill
/// lines.
std::string written_value(const Value& value, const WritingPlace& place);

}  // namespace meristem
