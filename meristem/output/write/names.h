// SPDX-License-Identifier: Apache-2.0
// Names in the forms of text formats.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meristem {

/// Returns `text` as one line. Control characters become spaces. Texts over 200 bytes are cut between characters, since
/// some readers of PLY accept lines of at most 1024 bytes.
std::string single_line(std::string_view text);

/// Returns `text` as one word: white space, control characters, `#` and `\` become `_`. Returns "_" for an empty text.
std::string single_word(std::string_view text);

/// Returns `text` as a part of a file name: like `single_word`, and `/` also becomes `_`.
std::string file_word(std::string_view text);

/// Returns `text` with the letters A to Z in lower case.
std::string lower_case(std::string_view text);

/// Returns one unique word per name. A word that exists already gets the suffix `_2`, `_3`, ...
std::vector<std::string> distinct_words(std::span<const std::string> names);

}  // namespace meristem
