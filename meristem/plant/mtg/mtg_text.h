// SPDX-License-Identifier: Apache-2.0
// Lines, cells and errors of an MTG file, for its reader.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/reading_stop.h"

namespace meristem {

/// A piece of a line without blanks at its ends.
struct MtgWord {
  std::string_view text;
  std::size_t offset = 0;  ///< bytes from the begin of the line
};

/// A line without its comment.
struct MtgLine {
  std::string_view text;
  std::uint32_t number = 0;  ///< from 1

  /// Splits the line at blanks and tabs.
  std::vector<MtgWord> words() const;
  /// Splits the line at tabs. Cells may be empty.
  std::vector<MtgWord> cells() const;
};

/// Iterates over the lines of a text, without empty ones.
class MtgLines {
 public:
  explicit MtgLines(std::string_view text);
  bool next(MtgLine& line);
  std::uint32_t last_number() const { return number_; }

 private:
  StopCounter stop_;
  std::string_view rest_;
  std::uint32_t number_ = 0;
};

/// Collects errors, and throws them if there are too many.
class MtgErrors {
 public:
  MtgErrors(std::string file, std::uint64_t max) : file_(std::move(file)), max_(max) {}

  /// Adds an error at byte `offset` of a line. The diagnostic must not yet have file, line or column.
  void add(const MtgLine& line, std::size_t offset, Diagnostic diagnostic);
  /// Adds an error at byte `offset` of a line and throws all errors.
  [[noreturn]] void fail(const MtgLine& line, std::size_t offset, Diagnostic diagnostic);
  void throw_if_any() const;

 private:
  std::string file_;
  std::uint64_t max_;
  std::vector<Diagnostic> errors_;
};

/// Returns a text as messages show it, shortened if it is long.
std::string shown(std::string_view text);

/// Parses the whole text as a finite number.
std::optional<double> to_number(std::string_view text);

/// Parses the number and rounds it once to 32 bits. The shortest digits of a float therefore give that float.
std::optional<float> to_float(std::string_view text);

}  // namespace meristem
