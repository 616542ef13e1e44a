// SPDX-License-Identifier: Apache-2.0
// `#include`: a letter that is drawn as the word of another grammar. Private to the reader of grammars.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/grow/lsystem/grammar.h"

namespace meristem {

/// Largest number of modules of an included word, because each module is stored as a template.
inline constexpr std::size_t kLongestIncludedWord = 1'000'000;

/// Returns the interpreted word of `included` after `steps` steps, in letters of `alphabet`. Adds missing letters to
/// `alphabet`. Throws InputError as derive() does, and std::length_error if the alphabet is full.
std::vector<ModuleTemplate> included_word(const Grammar& included, double steps, const SizeLimits& limits,
                                          Alphabet& alphabet);

}  // namespace meristem
