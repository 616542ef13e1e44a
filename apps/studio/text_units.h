// SPDX-License-Identifier: Apache-2.0
// Texts as the page counts them: in UTF-16 code units, where the library counts bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/document/edit/patch.h"

namespace meristem::studio {

/// The hash of a text that page and server compare, 16 hexadecimal digits; protocol.md defines it. Not for secrets.
std::string text_hash(std::string_view text);

/// UTF-16 code units of a text.
std::size_t unit_count(std::string_view text);

/// Line and column of a diagnostic.
struct LineColumn {
  int line = 0;
  int column = 0;
  auto operator<=>(const LineColumn&) const = default;
};

/// Where each line and column stands in the text, counted in units; the text's end for what lies beyond it. Passes over
/// the text once, however many places there are.
std::vector<std::size_t> units_of(std::string_view text, const std::vector<LineColumn>& places);

/// One piece of a text and what stands there instead, in units.
struct UnitSplice {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string replacement;

  bool operator==(const UnitSplice&) const = default;
};

/// The patch of `text` in bytes. Throws std::invalid_argument where the splices do not rise, overlap, lie outside of
/// the text or begin or end within a character.
Patch in_bytes(std::string_view text, const std::vector<UnitSplice>& splices);

/// The patch of `text`, which is sound, in units.
std::vector<UnitSplice> in_units(std::string_view text, const Patch& patch);

}  // namespace meristem::studio
