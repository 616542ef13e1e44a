// SPDX-License-Identifier: Apache-2.0
// The lowest layer of the reader of grammars: a text in which comments are blanked and every byte keeps its position,
// and the list of errors. Pieces of the text are views into it, so that the position of a piece is known. Private to
// the reader.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"

namespace meristem {

/// Returns the text without the blanks at both ends.
std::string_view trimmed(std::string_view text);
bool is_blank(char c);
/// Returns the number of bytes of the first character. `text` is UTF-8 and not empty.
std::size_t character_bytes(std::string_view text);

class GrammarText {
 public:
  /// Replaces comments, joined line ends and the byte order mark by blanks. Throws InputError if the text is too long,
  /// is not UTF-8, or ends within a comment.
  GrammarText(std::string_view text, std::string file, const SizeLimits& limits);
  GrammarText(const GrammarText&) = delete;
  GrammarText& operator=(const GrammarText&) = delete;

  /// Returns the lines that are not blank, trimmed.
  std::vector<std::string_view> lines() const;
  /// Returns the offset of `piece`, which must be a part of the lines.
  std::size_t offset(std::string_view piece) const;
  int line(std::string_view piece) const;
  const std::string& file() const { return file_; }

  Diagnostic error(std::size_t offset, std::string message, std::string expected, std::string nearest = "") const;

 private:
  void remove_comments();
  void blank(std::size_t begin, std::size_t end);

  std::string text_;
  std::string file_;
  std::vector<std::size_t> line_starts_;
};

/// Collects errors and warnings, up to the limit of each.
class GrammarErrors {
 public:
  GrammarErrors(const GrammarText& text, std::size_t max) : text_(text), max_(max) {}

  /// Adds an error. `at` is a piece of the text.
  void add(std::string_view at, std::string message, std::string expected, std::string nearest = "");
  /// Adds a warning. Rules without a place in the text, `{}`, cause no warnings.
  void warn(std::string_view at, std::string message, std::string expected = "");
  /// Adds the errors of an included file, at the position of its inclusion.
  void add_all(std::string_view at, const std::vector<Diagnostic>& others);

  bool is_full() const { return errors_.size() >= max_; }
  bool is_empty() const { return errors_.empty(); }
  /// In the order of the text.
  std::vector<Diagnostic> take_errors() { return sorted(std::move(errors_)); }
  std::vector<Diagnostic> take_warnings() { return sorted(std::move(warnings_)); }

 private:
  struct Placed {
    std::size_t offset;
    Diagnostic diagnostic;
  };
  static std::vector<Diagnostic> sorted(std::vector<Placed> placed);

  const GrammarText& text_;
  std::size_t max_;
  std::vector<Placed> errors_;
  std::vector<Placed> warnings_;
};

}  // namespace meristem
