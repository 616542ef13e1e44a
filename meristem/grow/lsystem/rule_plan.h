// SPDX-License-Identifier: Apache-2.0
// Rules made ready for rewriting: what each needs to know of a word and what it writes, expressions apart from what
// takes none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "meristem/grow/lsystem/grammar.h"
#include "meristem/grow/lsystem/word_context.h"

namespace meristem {

/// What becomes of a module: 0 where it is copied, else the rule's index + 1.
using RuleChoice = std::uint16_t;
inline constexpr RuleChoice kCopied = 0;
/// The choice for letters whose rules have to be tried module by module.
inline constexpr RuleChoice kUndecided = std::numeric_limits<RuleChoice>::max();

/// Where the values of a variable come from.
struct VariableSource {
  static constexpr std::uint32_t kAge = std::numeric_limits<std::uint32_t>::max();  ///< in place of a module's number

  std::uint32_t variable = 0;
  std::uint32_t module = 0;  ///< 0 the predecessor, then the modules of the left and of the right context, from 1
  std::uint32_t parameter = 0;
};

/// An expression of a rule and what it needs.
struct RuleFormula {
  Expression expression;
  std::uint64_t stream = 0;             ///< of its random numbers, different in all expressions of the rule set
  std::vector<VariableSource> sources;  ///< of the variables that it uses
  std::vector<std::uint32_t> places;    ///< among the successor's parameters, of those that have this value
};

struct RulePlan {
  const Rule* rule = nullptr;
  std::uint32_t index = 0;  ///< in its set
  bool has_context = false;
  bool is_identity = false;  ///< writes what was there
  std::optional<RuleFormula> condition;
  std::optional<RuleFormula> life;
  std::optional<RuleFormula> weight;

  std::vector<LetterIndex> letters;  ///< of the successor
  std::vector<double> parameters;    ///< of the successor; those that are no constants are zero here
  struct Copy {
    VariableSource source;
    std::uint32_t place = 0;
  };
  std::vector<Copy> copies;
  std::vector<RuleFormula> formulas;

  bool is_constant() const { return copies.empty() && formulas.empty(); }
};

/// A rule set made ready.
struct RewritePlan {
  /// Throws InputError beyond 65,534 rules.
  RewritePlan(const Grammar& grammar, const RuleSet& set);

  const RuleSet* set = nullptr;
  std::vector<RulePlan> rules;
  std::vector<RuleChoice> by_letter;           ///< what becomes of it; kUndecided where that takes more than the letter
  std::vector<std::int64_t> added_modules;     ///< by choice
  std::vector<std::int64_t> added_parameters;  ///< by choice
  ContextNeeds needs;
  bool is_decided = true;  ///< all letters tell what becomes of them
  bool is_random = false;  ///< chance decides which rule applies
};

}  // namespace meristem
