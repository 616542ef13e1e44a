// SPDX-License-Identifier: Apache-2.0
// Parses seeds. The whole text must be digits, and the number must fit into a JSON number.
#include "meristem/base/seed.h"

#include <charconv>

namespace meristem {

std::optional<std::uint64_t> seed_of_text(std::string_view text) {
  std::uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, seed);
  if (error != std::errc() || rest != end || seed > kLargestSeed) return {};
  return seed;
}

}  // namespace meristem
