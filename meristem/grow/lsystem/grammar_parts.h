// SPDX-License-Identifier: Apache-2.0
// The kit of grammar parts: short lists of interpretation rules for forms that many plants share. A grammar includes a
// part by its name, `#include "meristem/whorl"`, and then uses the part's symbols. The rules of the grammar itself take
// precedence over the rules of the part.
#pragma once

#include <span>
#include <string_view>

namespace meristem {

/// Path before the names of parts in `#include`.
inline constexpr std::string_view kPartsFolder = "meristem/";

/// A part of the kit.
struct GrammarPart {
  std::string_view name;  ///< name behind kPartsFolder
  std::string_view doc;   ///< the symbol with its parameters, and its effect, in one sentence
  std::string_view text;  ///< `#symbols` and interpretation rules
};

/// Returns all parts, by name.
std::span<const GrammarPart> grammar_parts();

/// Returns the part of this name, without its folder. Returns null if there is none.
const GrammarPart* find_grammar_part(std::string_view name);

}  // namespace meristem
