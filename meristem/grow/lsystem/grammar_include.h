// SPDX-License-Identifier: Apache-2.0
// `#include`: a letter that is drawn as the word of another grammar. Private to the reader of grammars.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/grow/lsystem/grammar.h"

namespace meristem {

/// More modules than this are refused where a grammar is included: each of them is kept as a form of its own.
inline constexpr std::size_t kLongestIncludedWord = 1'000'000;

/// The drawn word of `included` after `steps` steps, in letters of `alphabet`, which takes those that it has not.
/// Throws InputError as `derive` does, and std::length_error where the alphabet is full.
std::vector<ModuleTemplate> included_word(const Grammar& included, double steps, const Limits& limits,
                                          Alphabet& alphabet);

}  // namespace meristem
