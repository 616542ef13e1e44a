// SPDX-License-Identifier: Apache-2.0
// Checks relations between the rules of a grammar. Private to the reader of grammars.
#pragma once

#include <string_view>
#include <vector>

#include "meristem/grow/lsystem/grammar.h"
#include "meristem/grow/lsystem/grammar_text.h"

namespace meristem {

/// The text position of each rule of the three sets. Rules of inclusions have the position of their directive.
struct RuleTexts {
  std::vector<std::string_view> production;
  std::vector<std::string_view> decomposition;
  std::vector<std::string_view> interpretation;
};

/// Warns of rules that can never match. No word has their predecessor or a required neighbour, or an earlier rule
/// always applies.
void warn_of_idle_rules(const Grammar& grammar, const RuleTexts& places, GrammarErrors& errors);

}  // namespace meristem
