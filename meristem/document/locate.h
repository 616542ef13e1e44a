// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// With which some programs begin a text.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A position in a text.
struct TextPosition {
  int line = 1;    ///< from 1
  int column = 1;  ///< in characters, from 1
};

/// Where the byte at `offset` stands; offsets past the end count as the end. A byte order mark does not count, bytes
/// within a character count as its first.
TextPosition text_position(std::string_view text, std::size_t offset);

/// Where in the JSON `text` each byte of the text value at `begin` stands, escapes counted, and last its closing quote.
std::vector<std::size_t> places_of_bytes(std::string_view text, std::size_t begin);

/// The value of a JSON text whose faults say that they are of `file`. Throws InputError.
Value parse_json_of(const std::string& text, const std::string& file);

/// Fills line and column of the diagnostics that have a path, from the JSON `text` in which they arose: those of the
/// value at the path, of the member's name (kAtName), or of a byte within the text there. Paths not in the text take
/// the path of the longest part of them that is. Two passes over the text however many diagnostics; text that is not
/// JSON leaves the rest unplaced. Throws Cancelled soon after `progress` was asked to stop; null: it cannot be stopped.
void locate_diagnostics(std::string_view text, std::span<Diagnostic> diagnostics, const Progress* progress = nullptr);

}  // namespace meristem
