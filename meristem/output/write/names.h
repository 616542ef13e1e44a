// SPDX-License-Identifier: Apache-2.0
// Names as text formats can hold them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meristem {

/// `text` as one line: control characters become spaces, and what is longer than 200 bytes is cut between characters,
/// since readers of PLY know lines of 1024 bytes at most.
std::string single_line(std::string_view text);

/// `text` as one word: white space, control characters, `#` and `\` become `_`; "_" for an empty text.
std::string single_word(std::string_view text);

/// `text` as a part of a file's name: `single_word`, and `/` becomes `_`, too.
std::string file_word(std::string_view text);

/// `text` with the letters A to Z as small ones.
std::string lower_case(std::string_view text);

/// One word a name, no two alike: a word that is taken gets `_2`, `_3`, ... behind it.
std::vector<std::string> distinct_words(std::span<const std::string> names);

}  // namespace meristem
