// SPDX-License-Identifier: Apache-2.0
// Finds lines, indentation and comments around a position in JSON text, and writes values in a matching layout.
// Searches stay within a line or a comment, so edits of a large text take little time.
#include "meristem/document/edit/layout.h"

#include <algorithm>

#include "meristem/document/edit/located_tree.h"
#include "meristem/document/json.h"

namespace meristem {

namespace {

bool is_blank_in_line(char c) { return c == ' ' || c == '\t' || c == '\r'; }

bool holds_object(const Value& value) {
  if (value.object() != nullptr) return true;
  return value.list() != nullptr && std::any_of(value.list()->begin(), value.list()->end(), holds_object);
}

std::string joined(std::string_view first, std::string_view second) { return std::string(first) + std::string(second); }

/// Returns a list with as many elements per line as fit.
std::string filled_list(const Value::List& list, const WritingPlace& place) {
  const std::string indent = joined(place.indent, place.unit);
  const std::string new_line = joined(place.line_end, indent);
  std::string made = "[" + new_line;
  std::size_t column = indent.size();
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::string part = write_json_line(list[k]) + (k + 1 < list.size() ? "," : "");
    if (k > 0 && column + 1 + part.size() > kLongestLine) {
      made += new_line;
      column = indent.size();
    } else if (k > 0) {
      made += ' ';
      ++column;
    }
    made += part;
    column += part.size();
  }
  return made + joined(place.line_end, place.indent) + "]";
}

}  // namespace

std::string_view line_end_of(std::string_view text) {
  const std::size_t end = text.find('\n');
  return end != std::string_view::npos && end > 0 && text[end - 1] == '\r' ? "\r\n" : "\n";
}

std::string_view indent_unit_of(std::string_view text) {
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
    const std::size_t end = text.find_first_not_of(" \t", at + 1);
    if (end == std::string_view::npos) break;
    const bool is_empty = text[end] == '\n' || text[end] == '\r';
    if (end > at + 1 && !is_empty) return text.substr(at + 1, end - at - 1);
  }
  return "  ";
}

std::size_t line_begin(std::string_view text, std::size_t offset) {
  const std::size_t end = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  return end == std::string_view::npos ? 0 : end + 1;
}

std::string_view indent_at(std::string_view text, std::size_t offset) {
  const std::size_t begin = line_begin(text, offset);
  const std::size_t end = std::min(text.find_first_not_of(" \t", begin), text.size());
  return text.substr(begin, end - begin);
}

bool begins_line(std::string_view text, std::size_t offset) {
  while (offset > 0 && (text[offset - 1] == ' ' || text[offset - 1] == '\t')) --offset;
  return offset > 0 && text[offset - 1] == '\n';
}

bool ends_line(std::string_view text, std::size_t offset, std::size_t* behind) {
  while (offset < text.size() && is_blank_in_line(text[offset])) ++offset;
  if (offset < text.size() && text[offset] != '\n') return false;
  if (behind != nullptr) *behind = std::min(offset + 1, text.size());
  return true;
}

std::size_t behind_comments(std::string_view text, std::size_t offset) {
  std::size_t behind = offset;
  for (;;) {
    std::size_t at = behind;
    while (at < text.size() && is_blank_in_line(text[at])) ++at;
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("//")) return std::min(text.find_first_of("\r\n", at), text.size());
    if (!rest.starts_with("/*")) return behind;
    // Only the comment is searched, because its line may be the whole text.
    const std::size_t end = text.find("*/", at + 2);
    if (end == std::string_view::npos || text.substr(at, end - at).find('\n') != std::string_view::npos) return behind;
    behind = end + 2;
  }
}

std::vector<Comment> comments_between(std::string_view text, std::size_t begin, std::size_t end) {
  std::vector<Comment> comments;
  while (begin < end) {
    const std::string_view rest = text.substr(begin, end - begin);
    const bool to_line_end = rest.starts_with("//");
    if (!to_line_end && !rest.starts_with("/*")) {
      ++begin;
      continue;
    }
    std::size_t stop = to_line_end ? text.find_first_of("\r\n", begin) : text.find("*/", begin + 2);
    stop = stop == std::string_view::npos ? end : std::min(to_line_end ? stop : stop + 2, end);
    comments.push_back({begin, stop, to_line_end});
    begin = stop;
  }
  return comments;
}

std::string written_value(const Value& value, const WritingPlace& place) {
  std::string line = write_json_line(value);
  const std::size_t count = part_count(value);
  if (count == 0 || place.column + line.size() <= kLongestLine) return line;
  if (!holds_object(value)) return filled_list(*value.list(), place);
  const bool is_list = value.list() != nullptr;
  const std::string indent = joined(place.indent, place.unit);
  std::string made = is_list ? "[" : "{";
  for (std::size_t k = 0; k < count; ++k) {
    made += k > 0 ? "," : "";
    made += place.line_end;
    made += indent;
    std::string name;
    if (!is_list) name = write_json_line(Value((*value.object())[k].first)) + ": ";
    const Value& part = is_list ? (*value.list())[k] : (*value.object())[k].second;
    made += name + written_value(part, {indent, place.unit, place.line_end, indent.size() + name.size() + 1});
  }
  return made + joined(place.line_end, place.indent) + (is_list ? "]" : "}");
}

}  // namespace meristem
