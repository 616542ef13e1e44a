// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace meristem {

/// Returns the bytes of the UTF-8 character that `text` begins with. Returns 0 if `text` is empty or begins with none:
/// overlong forms, surrogates and values above U+10FFFF are no characters.
std::size_t utf8_character_bytes(std::string_view text);

/// Returns the offset of the first byte that is not UTF-8, or `text.size()` if all of `text` is.
std::size_t find_invalid_utf8(std::string_view text);

/// Returns `text` with U+FFFD in the place of each byte that is not UTF-8. Valid text stays as it is.
std::string with_valid_utf8(std::string text);

}  // namespace meristem
