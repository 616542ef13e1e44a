// SPDX-License-Identifier: Apache-2.0
// The layer under the reader of grammars: a text without its comments in which every byte keeps its position, and the
// list of what is wrong with it. Pieces of the text are views into it, so that a piece knows its position. Private to
// the reader.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"

namespace meristem {

/// Without the blanks at both ends.
std::string_view trimmed(std::string_view text);
bool is_blank(char c);
/// Bytes of the first character. `text` is UTF-8 and not empty.
std::size_t character_bytes(std::string_view text);

class GrammarText {
 public:
  /// Replaces comments, joined line ends and the byte order mark by blanks. Throws InputError for text that is too
  /// long, is not UTF-8, or ends within a comment.
  GrammarText(std::string_view text, std::string file, const Limits& limits);
  GrammarText(const GrammarText&) = delete;
  GrammarText& operator=(const GrammarText&) = delete;

  /// The lines that are not blank, trimmed.
  std::vector<std::string_view> lines() const;
  /// Where `piece` of the lines begins.
  std::size_t offset(std::string_view piece) const;
  int line(std::string_view piece) const;
  const std::string& file() const { return file_; }

  Diagnostic fault(std::size_t offset, std::string message, std::string expected, std::string nearest = "") const;

 private:
  void remove_comments();
  void blank(std::size_t begin, std::size_t end);

  std::string text_;
  std::string file_;
  std::vector<std::size_t> line_starts_;
};

/// Collects faults and warnings, up to the limit of each.
class GrammarFaults {
 public:
  GrammarFaults(const GrammarText& text, std::size_t most) : text_(text), most_(most) {}

  /// `at` is a piece of the text.
  void add(std::string_view at, std::string message, std::string expected, std::string nearest = "");
  void warn(std::string_view at, std::string message, std::string expected = "");
  /// Faults of an included file, at the position of its inclusion.
  void add_all(std::string_view at, const std::vector<Diagnostic>& others);

  bool is_full() const { return faults_.size() >= most_; }
  bool is_empty() const { return faults_.empty(); }
  /// In the order of the text.
  std::vector<Diagnostic> take_faults() { return sorted(std::move(faults_)); }
  std::vector<Diagnostic> take_warnings() { return sorted(std::move(warnings_)); }

 private:
  struct Placed {
    std::size_t offset;
    Diagnostic diagnostic;
  };
  static std::vector<Diagnostic> sorted(std::vector<Placed> placed);

  const GrammarText& text_;
  std::size_t most_;
  std::vector<Placed> faults_;
  std::vector<Placed> warnings_;
};

}  // namespace meristem
