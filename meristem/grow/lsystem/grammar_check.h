// SPDX-License-Identifier: Apache-2.0
// What a grammar's rules are to each other: private to the reader of grammars.
#pragma once

#include <string_view>
#include <vector>

#include "meristem/grow/lsystem/grammar.h"
#include "meristem/grow/lsystem/grammar_text.h"

namespace meristem {

/// Where each rule of the three sets stands in the text; rules of inclusions stand at their directive.
struct RuleTexts {
  std::vector<std::string_view> production;
  std::vector<std::string_view> decomposition;
  std::vector<std::string_view> interpretation;
};

/// Warns of rules that can never match: no word has their predecessor or a neighbour that they ask for, or an earlier
/// rule is always taken.
void warn_of_idle_rules(const Grammar& grammar, const RuleTexts& places, GrammarFaults& faults);

}  // namespace meristem
