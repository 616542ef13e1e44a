// SPDX-License-Identifier: Apache-2.0
// Changes of a text as replaced pieces. All other bytes stay.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace meristem {

/// A piece of a text and its replacement.
struct TextSplice {
  std::size_t offset = 0;   ///< byte in the text before the whole patch
  std::size_t length = 0;   ///< number of removed bytes
  std::string replacement;  ///< inserted bytes

  bool operator==(const TextSplice&) const = default;
};

/// Splices in rising order that do not overlap. All offsets refer to the text before the patch.
using TextPatch = std::vector<TextSplice>;

/// Returns true if the splices are in rising order, do not overlap and lie within a text of that size. Splices may
/// touch each other, and several may insert at one offset. All functions below require this.
bool is_sound(const TextPatch& patch, std::size_t text_size);

/// Returns the text with the patch. Throws std::invalid_argument if the patch is not sound.
std::string apply_patch(std::string_view text, const TextPatch& patch);

/// Returns the patch that turns the patched text back into `text`. Throws std::invalid_argument if the patch is not
/// sound.
TextPatch inverse_patch(std::string_view text, const TextPatch& patch);

/// Joins successive patches. Joins pairs of about equal size, so that n patches take time in proportion to n log n.
class PatchJoiner {
 public:
  /// Adds the next patch. Its offsets refer to the text after all patches so far.
  void add(TextPatch patch);
  /// Returns one patch for all. Returns an empty patch if none was added.
  TextPatch joined() const;

 private:
  struct Run {
    TextPatch patch;
    std::size_t count = 0;  // patches that were joined
  };
  std::vector<Run> runs_;  // each has at least as many patches as the next one
};

/// Returns one patch for two successive ones. Offsets of `second` refer to the text that `first` has made. Both patches
/// must be sound; the function does not check this.
TextPatch joined_patches(const TextPatch& first, const TextPatch& second);

}  // namespace meristem
