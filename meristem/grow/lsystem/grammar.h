// SPDX-License-Identifier: Apache-2.0
// Compiled grammars: parametric, context-sensitive, stochastic, bracketed L-systems.
//
// Based on: P. Prusinkiewicz, A. Lindenmayer: The Algorithmic Beauty of Plants (1990), chapters 1 to 4, and 6 for
// grammars in continuous time, whose modules have ages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/expression/expression.h"
#include "meristem/grow/lsystem/word.h"

namespace meristem {

/// The largest number of parameters of a rule: both contexts and the predecessor together. Also the limit for one
/// letter.
inline constexpr std::size_t kMaxVariables = 64;
/// The largest number of steps; more are an error.
inline constexpr int kMaxSteps = 1'000'000;

/// A module of a successor or an axiom, with an expression for each parameter.
struct ModuleTemplate {
  LetterIndex letter = kNoLetter;      ///< letter of the module
  std::vector<Expression> parameters;  ///< as many as the letter has parameters
};

/// A module of a context. It matches modules with its letter, and their parameters become variables of the rule.
struct ContextModule {
  LetterIndex letter = kNoLetter;    ///< letter that the module must have
  std::uint32_t first_variable = 0;  ///< index of the rule's variable for this module's first parameter
};

/// `[id :] [left <] predecessor [> right] [@ life] [: condition] [: weight] -> successor`.
struct GrammarRule {
  std::string text;                     ///< as written, for messages
  int line = 0;                         ///< line in the grammar's text, from 1
  LetterIndex predecessor = kNoLetter;  ///< letter that the rule replaces
  std::uint32_t first_variable = 0;     ///< index of the predecessor's first parameter
  /// Parameters of left context, predecessor and right context together, and the age.
  std::uint32_t variable_count = 0;
  bool sees_age = false;                ///< true: the last variable is the age of the predecessor's module
  std::vector<ContextModule> left;      ///< from the root toward the predecessor; without brackets
  std::vector<ContextModule> right;     ///< away from the predecessor; may contain the letters of [ and ]
  std::optional<Expression> condition;  ///< the rule applies where this holds; unset: everywhere
  /// The age at which a module of a timed grammar is replaced.
  std::optional<Expression> life;
  /// Weight of a stochastic rule: among matching rules, one is drawn with a probability proportional to its weight.
  std::optional<Expression> weight;
  std::vector<ModuleTemplate> successor;  ///< modules that replace the predecessor; may be empty
};

/// Rules by predecessor, in the order of the text.
struct RuleSet {
  std::vector<GrammarRule> rules;                     ///< in the order of the text
  std::vector<std::vector<std::uint32_t>> of_letter;  ///< indices into `rules`, one list per letter of the alphabet
};

/// A grammar that read_grammar() has compiled.
struct Grammar {
  std::string file;                   ///< name of the grammar in messages
  Alphabet alphabet;                  ///< all letters of the text
  LetterIndex open = kNoLetter;       ///< [
  LetterIndex close = kNoLetter;      ///< ]
  LetterIndex cut = kNoLetter;        ///< %
  std::vector<ModuleTemplate> axiom;  ///< the first word of a derivation; its expressions are constants
  RuleSet production;                 ///< applied once per step
  RuleSet decomposition;              ///< applied after each step until none applies
  RuleSet interpretation;             ///< applied before drawing until none applies; does not change the derived word
  std::vector<std::uint8_t> is_ignored;  ///< ignored by contexts; one flag per letter
  /// True if rules have lives and words depend on time: all modules age, and each is replaced at the end of its life.
  bool is_timed = false;
  bool asks_ages = false;       ///< true: rules use the ages of modules, so words must store births
  std::optional<int> steps;     ///< #steps
  std::optional<double> time;   ///< #time of a timed grammar
  std::optional<double> angle;  ///< #angle, degrees
};

}  // namespace meristem
