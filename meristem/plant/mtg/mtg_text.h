// SPDX-License-Identifier: Apache-2.0
// The lines, cells and faults of an MTG file, for its reader.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/diagnostic.h"

namespace meristem {

/// A piece of a line without blanks at its ends.
struct MtgWord {
  std::string_view text;
  std::size_t offset = 0;  ///< bytes from the line's begin
};

/// A line without its comment.
struct MtgLine {
  std::string_view text;
  std::uint32_t number = 0;  ///< from 1

  /// What blanks and tabs part.
  std::vector<MtgWord> words() const;
  /// What tabs part; cells may be empty.
  std::vector<MtgWord> cells() const;
};

/// Goes through a text's lines, without empty ones.
class MtgLines {
 public:
  explicit MtgLines(std::string_view text);
  bool next(MtgLine& line);
  std::uint32_t last_number() const { return number_; }

 private:
  std::string_view rest_;
  std::uint32_t number_ = 0;
};

/// Collects faults, and throws them when there are too many to go on.
class MtgFaults {
 public:
  MtgFaults(std::string file, std::uint64_t most) : file_(std::move(file)), most_(most) {}

  /// At byte `offset` of a line. The diagnostic has neither file, line nor column yet.
  void add(const MtgLine& line, std::size_t offset, Diagnostic diagnostic);
  /// Adds a fault at byte `offset` of a line and throws all faults.
  [[noreturn]] void fail(const MtgLine& line, std::size_t offset, Diagnostic diagnostic);
  void throw_if_any() const;

 private:
  std::string file_;
  std::uint64_t most_;
  std::vector<Diagnostic> faults_;
};

/// A text as a message shows it, cut where it is long.
std::string shown(std::string_view text);

/// The whole text as a finite number.
std::optional<double> to_number(std::string_view text);

/// The number, rounded once to 32 bits: so a float's shortest digits give that float.
std::optional<float> to_float(std::string_view text);

}  // namespace meristem
