// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace meristem {

/// Returns the number of bytes of the UTF-8 character at the beginning of `text`. Returns 0 if `text` is empty or does
/// not begin with a valid character. Overlong forms, surrogates and values above U+10FFFF are invalid.
std::size_t utf8_character_bytes(std::string_view text);

/// Returns the offset of the first byte that is not valid UTF-8, or `text.size()` if the whole text is valid.
std::size_t find_invalid_utf8(std::string_view text);

/// Returns `text` with each invalid byte replaced by U+FFFD. Valid text stays unchanged.
std::string with_valid_utf8(std::string text);

}  // namespace meristem
