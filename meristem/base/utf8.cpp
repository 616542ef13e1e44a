// SPDX-License-Identifier: Apache-2.0
// Checks and repairs UTF-8. The first byte of a character gives its length and the range of its second byte, which
// excludes overlong forms, surrogates and values above U+10FFFF.
#include "meristem/base/utf8.h"

namespace meristem {

namespace {

unsigned char byte_at(std::string_view text, std::size_t offset) { return static_cast<unsigned char>(text[offset]); }

}  // namespace

std::size_t utf8_character_bytes(std::string_view text) {
  if (text.empty()) return 0;
  const unsigned char lead = byte_at(text, 0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte_at(text, k) & 0xC0U) != 0x80U) return 0;
  }
  const unsigned char second = byte_at(text, 1);
  const bool is_overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool is_surrogate = lead == 0xED && second >= 0xA0;
  const bool is_too_large = lead == 0xF4 && second >= 0x90;
  return is_overlong || is_surrogate || is_too_large ? 0 : length;
}

std::size_t find_invalid_utf8(std::string_view text) {
  std::size_t offset = 0;
  while (offset < text.size()) {
    const std::size_t length = utf8_character_bytes(text.substr(offset));
    if (length == 0) return offset;
    offset += length;
  }
  return offset;
}

std::string with_valid_utf8(std::string text) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
  std::size_t invalid = find_invalid_utf8(text);
  if (invalid == text.size()) return text;
  std::string valid;
  std::string_view rest = text;
  while (!rest.empty()) {
    valid += rest.substr(0, invalid);
    rest.remove_prefix(invalid);
    if (rest.empty()) break;
    valid += kReplacement;
    rest.remove_prefix(1);
    invalid = find_invalid_utf8(rest);
  }
  return valid;
}

}  // namespace meristem
