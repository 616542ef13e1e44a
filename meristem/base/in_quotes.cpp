// SPDX-License-Identifier: Apache-2.0
// Quotes a text for a message. A long text is cut before the character that would exceed the limit.
#include "meristem/base/in_quotes.h"

#include <cstddef>

#include <fmt/format.h>

#include "meristem/base/visible_text.h"

namespace meristem {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() <= kLongest) return fmt::format("'{}'", visible_text(text));
  // Bytes that continue a character begin with the bits 10.
  const auto goes_on = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; };
  std::size_t length = kLongest;
  while (length > 0 && goes_on(text[length])) --length;
  return fmt::format("'{}...'", visible_text(text.substr(0, length)));
}

}  // namespace meristem
