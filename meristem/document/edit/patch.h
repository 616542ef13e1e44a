// SPDX-License-Identifier: Apache-2.0
// Changes of a text as pieces that are replaced, so that all else keeps its bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meristem {

/// One piece of a text and what stands there instead.
struct Splice {
  std::size_t offset = 0;   ///< byte in the text before the whole patch
  std::size_t length = 0;   ///< bytes that go
  std::string replacement;  ///< what comes instead

  bool operator==(const Splice&) const = default;
};

/// Splices in rising order that do not overlap; all offsets are those of the text before the patch.
using Patch = std::vector<Splice>;

/// Whether the splices rise, do not overlap and lie within a text of that size: what all functions below ask for.
bool is_sound(const Patch& patch, std::size_t text_size);

/// The text with the patch. Throws std::invalid_argument where the patch is not sound.
std::string apply_patch(std::string_view text, const Patch& patch);

/// What gives the bytes of `text` back where it is applied to the patched text.
Patch inverse_patch(std::string_view text, const Patch& patch);

/// One patch for two that follow each other: `second` counts in the text that `first` has made.
Patch joined_patches(const Patch& first, const Patch& second);

}  // namespace meristem
