// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "meristem/base/diagnostic.h"

namespace meristem {

/// A finite or infinite number, or NaN, however large and in any locale; nothing for other texts.
std::optional<double> parse_number(std::string_view text);

/// Goes through a text word by word and knows the line and column of the last word.
class TextScanner {
 public:
  /// `file` is for messages; `separators` stand between words besides blanks.
  TextScanner(std::string_view text, std::string file, std::string_view separators = "")
      : text_(text), file_(std::move(file)), separators_(separators) {}

  /// The next word of this line; empty at its end. A backslash at the end of a line continues it.
  std::string_view word();
  /// The next word on this line or a later one; empty at the end of the text.
  std::string_view word_anywhere();
  /// Goes to the next line. False at the end of the text.
  bool next_line();

  std::size_t offset() const { return at_; }  ///< of the byte after the last word or line
  int line() const { return word_line_; }     ///< of the last word

  /// Throws InputError at the last word.
  [[noreturn]] void fail(std::string message, std::string expected, std::string nearest = {}) const;
  [[noreturn]] void fail(Diagnostic fault) const;

 private:
  void skip_blanks();

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
