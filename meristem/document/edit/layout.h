// SPDX-License-Identifier: Apache-2.0
// How a JSON text is laid out: its lines, indentation and comments, and how a new value would be written among them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/graph/table/value.h"

namespace meristem {

/// Lines longer than this are broken where something new is written.
inline constexpr std::size_t kLongestLine = 120;

/// A line's end as the text has it first; "\n" where it has none.
std::string_view line_end_of(std::string_view text);
/// One level of indentation: that of the first line that is indented; two blanks where there is none.
std::string_view indent_unit_of(std::string_view text);

/// Where the line of the byte at `offset` begins.
std::size_t line_begin(std::string_view text, std::size_t offset);
/// The blanks that this line begins with.
std::string_view indent_at(std::string_view text, std::size_t offset);
/// Whether nothing but blanks stands before `offset` in its line.
bool begins_line(std::string_view text, std::size_t offset);
/// Whether nothing but blanks follows in the line; then `behind` is where the next line begins (or the text's end).
bool ends_line(std::string_view text, std::size_t offset, std::size_t* behind = nullptr);
/// Behind the comments that follow in the line and end in it; `offset` where there is none.
std::size_t behind_comments(std::string_view text, std::size_t offset);

struct Comment {
  std::size_t begin = 0;
  std::size_t end = 0;  ///< of one with //, where its line ends
  bool to_line_end = false;
};
/// The comments between two tokens.
std::vector<Comment> comments_between(std::string_view text, std::size_t begin, std::size_t end);

/// Where a value is to be written.
struct WritingPlace {
  std::string_view indent;  ///< of the line
  std::string_view unit;
  std::string_view line_end;
  std::size_t column = 0;  ///< in the line, bytes
};

/// The value in one line where it fits; else a member per line, and lists without objects in filled lines.
std::string written_value(const Value& value, const WritingPlace& place);

}  // namespace meristem
