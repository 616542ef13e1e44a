// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "meristem/base/diagnostic.h"
#include "meristem/base/reading_stop.h"

namespace meristem {

/// Returns the number (finite, infinite or NaN) that a text contains, independent of the locale. Returns nothing for
/// other texts.
std::optional<double> parse_number(std::string_view text);

/// Iterates over the words of a text and keeps the line and column of the last word.
class TextScanner {
 public:
  /// `file` is used in messages. `separators` are characters that separate words in addition to blanks.
  TextScanner(std::string_view text, std::string file, std::string_view separators = "")
      : text_(text), file_(std::move(file)), separators_(separators) {}

  /// Returns the next word of this line, or an empty text at its end. A backslash at the end of a line continues the
  /// line.
  std::string_view word();
  /// Returns the next word on this or a later line, or an empty text at the end of the text.
  std::string_view word_anywhere();
  /// Moves to the next line. Returns false at the end of the text.
  bool next_line();

  std::size_t offset() const { return at_; }  ///< offset of the byte after the last word or line
  int line() const { return word_line_; }     ///< line of the last word

  /// Throws InputError at the last word.
  [[noreturn]] void fail(std::string message, std::string expected, std::string nearest = {}) const;
  [[noreturn]] void fail(Diagnostic error) const;

 private:
  void skip_blanks();

  StopCounter stop_;
  std::string_view text_;
  std::string file_;
  std::string_view separators_;
  std::size_t at_ = 0;
  std::size_t line_begin_ = 0;
  int line_ = 1;
  int word_line_ = 1;
  std::size_t word_column_ = 1;
};

}  // namespace meristem
