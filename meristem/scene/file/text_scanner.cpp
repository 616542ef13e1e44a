// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/file/text_scanner.h"

#include <charconv>
#include <limits>
#include <utility>

namespace meristem {

std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  if (parsed.ptr != text.data() + text.size() || parsed.ec == std::errc::invalid_argument) return std::nullopt;
  if (parsed.ec == std::errc::result_out_of_range) {
    const bool is_tiny = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
    return is_tiny ? 0 : std::numeric_limits<double>::infinity();
  }
  return value;
}

void TextScanner::skip_blanks() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    const std::string_view rest = text_.substr(at_);
    if (c == ' ' || c == '\t' || c == '\r' || separators_.find(c) != std::string_view::npos) {
      ++at_;
    } else if (rest.starts_with("\\\n") || rest.starts_with("\\\r\n")) {
      at_ += rest[1] == '\n' ? 2 : 3;
      line_begin_ = at_;
      ++line_;
    } else {
      return;
    }
  }
}

std::string_view TextScanner::word() {
  stop_.step();
  skip_blanks();
  word_line_ = line_;
  word_column_ = at_ - line_begin_ + 1;
  const std::size_t begin = at_;
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n' || separators_.find(c) != std::string_view::npos) break;
    ++at_;
  }
  return text_.substr(begin, at_ - begin);
}

std::string_view TextScanner::word_anywhere() {
  for (;;) {
    const std::string_view found = word();
    if (!found.empty() || !next_line()) return found;
  }
}

bool TextScanner::next_line() {
  stop_.step();
  const std::size_t end = text_.find('\n', at_);
  if (end == std::string_view::npos) {
    at_ = text_.size();
    return false;
  }
  at_ = end + 1;
  line_begin_ = at_;
  ++line_;
  return true;
}

void TextScanner::fail(std::string message, std::string expected, std::string nearest) const {
  fail(Diagnostic{.message = std::move(message), .expected = std::move(expected), .nearest = std::move(nearest)});
}

void TextScanner::fail(Diagnostic error) const {
  error.file = file_;
  error.line = word_line_;
  error.column = static_cast<int>(word_column_);
  throw InputError(std::move(error));
}

}  // namespace meristem
