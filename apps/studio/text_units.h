// SPDX-License-Identifier: Apache-2.0
// Converts positions in texts between the page, which counts UTF-16 code units, and the library, which counts bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/document/edit/patch.h"

namespace meristem::studio {

/// Returns the hash that page and server compare to find out whether their texts are equal: 16 hexadecimal digits,
/// defined in protocol.md. Not for secrets.
/// secrets.
std::string text_hash(std::string_view text);

/// Returns the number of UTF-16 code units of a text.
std::size_t unit_count(std::string_view text);

/// Line and column of a diagnostic.
struct LineColumn {
  int line = 0;
  int column = 0;
  auto operator<=>(const LineColumn&) const = default;
};

/// Returns the position of each line and column in the text, in units. Returns the text's end for positions beyond it.
/// Needs one pass over the text for any number of positions.
std::vector<std::size_t> units_of(std::string_view text, const std::vector<LineColumn>& places);

/// A piece of a text and its replacement, in units.
struct UnitSplice {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string replacement;

  bool operator==(const UnitSplice&) const = default;
};

/// Returns the patch of `text` in bytes. Throws std::invalid_argument if the splices are not in rising order, overlap,
/// lie outside of the text, or begin or end within a character.
TextPatch in_bytes(std::string_view text, const std::vector<UnitSplice>& splices);

/// Returns the patch of `text` in units. The patch must be valid.
std::vector<UnitSplice> in_units(std::string_view text, const TextPatch& patch);

}  // namespace meristem::studio
