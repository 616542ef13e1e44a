// SPDX-License-Identifier: Apache-2.0
// Checks whether the description of a parameter can be shown alone: in a tooltip, an editor's hover or a reference
// page.
#pragma once

#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace meristem {

/// Returns the error in a sentence that must stand alone, or an empty text.
inline std::string sentence_error(std::string_view sentence) {
  constexpr std::size_t kLongest = 200;  // bytes; three lines of a tooltip
  constexpr std::array<std::string_view, 22> kOpenings = {
      "Of ",     "The same", "In its", "That ",  "So many", "How they", "How it ",  "By which",
      "By how",  "Its ",     "It ",    "They ",  "Their ",  "Also ",    "Another ", "Within which",
      "At the ", "At which", "Else",   "Where ", "Which ",  "The one ",
  };
  constexpr std::array<std::string_view, 19> kLeanings = {
      "the former", "the latter", "as above",   "see above",   "in its stead", "n its place", "mother",
      "daughter",   " ditto",     "by which",   "of which",    "the same",     "so many",     "so much",
      "how they",   "hangs on",   "worked out", "come to lie", "heavier"};
  if (sentence.empty()) return "is empty";
  if (sentence.size() > kLongest) return "is too long for a tooltip";
  if (sentence.back() != '.') return "does not end with a full stop";
  const auto first = static_cast<unsigned char>(sentence.front());
  if (std::isupper(first) == 0 && std::isdigit(first) == 0) return "does not begin with a capital";
  for (const std::string_view opening : kOpenings) {
    if (sentence.starts_with(opening)) return "names no subject: it opens with '" + std::string(opening) + "'";
  }
  for (const std::string_view leaning : kLeanings) {
    if (sentence.find(leaning) != std::string_view::npos) return "has '" + std::string(leaning) + "'";
  }
  return "";
}

}  // namespace meristem
