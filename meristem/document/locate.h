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

/// The byte order mark, with which some programs begin a text.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A position in a text.
struct TextPosition {
  int line = 1;    ///< from 1
  int column = 1;  ///< in characters, from 1
};

/// Returns line and column of the byte at `offset`. Offsets past the end count as the end. A byte order mark does not
/// count, and bytes within a character count as its first byte.
TextPosition text_position(std::string_view text, std::size_t offset);

/// Returns for each byte of the text value at `begin` its position in the JSON `text`. Escapes are counted. The last
/// entry is the position of the closing quote.
std::vector<std::size_t> places_of_bytes(std::string_view text, std::size_t begin);

/// Parses a JSON text. Faults name `file`. Throws InputError.
Value parse_json_of(const std::string& text, const std::string& file);

/// Fills line and column of diagnostics that have a path, from the JSON `text` in which they arose. A diagnostic points
/// to the value at the path, to the member's name (kAtName), or to a byte within the text value. If the path is not in
/// the text, the longest beginning of the path that exists is used. Needs two passes over the text for any number of
/// diagnostics. In text that is not JSON, the rest stays unplaced. Throws Cancelled soon after `progress` was asked to
/// stop. Null: it cannot be stopped.
void locate_diagnostics(std::string_view text, std::span<Diagnostic> diagnostics, const Progress* progress = nullptr);

}  // namespace meristem
