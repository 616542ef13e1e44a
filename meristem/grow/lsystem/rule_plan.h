// SPDX-License-Identifier: Apache-2.0
// Rules prepared for rewriting: their inputs from a word and their outputs. Constants, copies and expressions are
// separated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "meristem/grow/lsystem/grammar.h"
#include "meristem/grow/lsystem/word_context.h"

namespace meristem {

/// The choice for a module: kCopied, or the rule's index + 1.
using RuleChoice = std::uint16_t;
inline constexpr RuleChoice kCopied = 0;
/// The choice for letters whose rules must be tested module by module.
inline constexpr RuleChoice kUndecided = std::numeric_limits<RuleChoice>::max();

/// The source of a variable's value.
struct VariableSource {
  /// Special module number of the age.
  static constexpr std::uint32_t kAge = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t variable = 0;
  std::uint32_t module = 0;  ///< 0: the predecessor; from 1: the modules of the left and then of the right context
  std::uint32_t parameter = 0;
};

/// An expression of a rule and its inputs.
struct RuleFormula {
  Expression expression;
  std::uint64_t stream = 0;             ///< random stream, different for all expressions of the rule set
  std::vector<VariableSource> sources;  ///< sources of the variables that it uses
  std::vector<std::uint32_t> places;    ///< positions among the successor's parameters that have this value
};

struct RulePlan {
  const GrammarRule* rule = nullptr;
  std::uint32_t index = 0;  ///< index in its rule set
  bool has_context = false;
  bool is_identity = false;  ///< true: the result equals the predecessor
  std::optional<RuleFormula> condition;
  std::optional<RuleFormula> life;
  std::optional<RuleFormula> weight;

  std::vector<LetterIndex> letters;  ///< letters of the successor
  std::vector<double> parameters;    ///< parameters of the successor; 0 if not constant
  struct Copy {
    VariableSource source;
    std::uint32_t place = 0;
  };
  std::vector<Copy> copies;
  std::vector<RuleFormula> formulas;

  bool is_constant() const { return copies.empty() && formulas.empty(); }
};

/// A prepared rule set.
struct RewritePlan {
  /// Throws InputError beyond 65,534 rules.
  RewritePlan(const Grammar& grammar, const RuleSet& set);

  const RuleSet* set = nullptr;
  std::vector<RulePlan> rules;
  std::vector<RuleChoice> by_letter;           ///< choice by letter; kUndecided if the letter alone does not decide
  std::vector<std::int64_t> added_modules;     ///< by choice
  std::vector<std::int64_t> added_parameters;  ///< by choice
  ContextNeeds needs;
  bool is_decided = true;  ///< true: the letter decides the choice for all letters
  bool is_random = false;  ///< true: the choice of rules is random
};

}  // namespace meristem
