// SPDX-License-Identifier: Apache-2.0
// Parametric, context-sensitive, stochastic, bracketed L-systems: what a grammar's text means, compiled.
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

/// The most parameters that both contexts and the predecessor of one rule have together, and so the most of one letter.
inline constexpr std::size_t kMostVariables = 64;
/// Largest number of steps; more are refused.
inline constexpr int kMostSteps = 1'000'000;

/// A module of a successor or an axiom: an expression for each parameter.
struct ModuleTemplate {
  LetterIndex letter = kNoLetter;
  std::vector<Expression> parameters;
};

/// A module of a context: it matches this letter, and its parameters become variables of the rule.
struct ContextModule {
  LetterIndex letter = kNoLetter;
  std::uint32_t first_variable = 0;  ///< the rule's variables from here on are this module's parameters
};

/// `[id :] [left <] predecessor [> right] [@ life] [: condition] [: weight] -> successor`.
struct Rule {
  std::string text;  ///< as written, for messages
  int line = 0;      ///< in the grammar's text, from 1
  LetterIndex predecessor = kNoLetter;
  std::uint32_t first_variable = 0;  ///< index of the predecessor's first parameter
  std::uint32_t variable_count = 0;  ///< parameters of left context, predecessor and right context together, and age
  bool sees_age = false;             ///< the last variable is the age of the predecessor's module
  std::vector<ContextModule> left;   ///< from the root toward the predecessor; no brackets
  std::vector<ContextModule> right;  ///< away from it; may hold brackets, whose modules have the letters of [ and ]
  std::optional<Expression> condition;
  /// The age at which a module of a timed grammar is replaced.
  std::optional<Expression> life;
  /// Weight of a stochastic rule: one of the rules that match is drawn in proportion to their weights.
  std::optional<Expression> weight;
  std::vector<ModuleTemplate> successor;
};

/// Rules by predecessor, in the order of the text.
struct RuleSet {
  std::vector<Rule> rules;
  std::vector<std::vector<std::uint32_t>> of_letter;  ///< indices into `rules`, one list per letter of the alphabet
};

struct Grammar {
  std::string file;  ///< the grammar's name in messages
  Alphabet alphabet;
  LetterIndex open = kNoLetter;          ///< [
  LetterIndex close = kNoLetter;         ///< ]
  LetterIndex cut = kNoLetter;           ///< %
  std::vector<ModuleTemplate> axiom;     ///< the word that derivation begins with; its expressions are constants
  RuleSet production;                    ///< one step
  RuleSet decomposition;                 ///< after each step, until none applies
  RuleSet interpretation;                ///< before drawing, until none applies; never changes the word that is derived
  std::vector<std::uint8_t> is_ignored;  ///< by contexts; one per letter
  /// Its rules have lives, and words stand at times: all modules grow older, and each is replaced at the end of its
  /// life.
  bool is_timed = false;
  bool asks_ages = false;       ///< rules see the ages of modules, so that words have to keep births
  std::optional<int> steps;     ///< #steps
  std::optional<double> time;   ///< #time, of a timed grammar
  std::optional<double> angle;  ///< #angle, degrees
};

}  // namespace meristem
