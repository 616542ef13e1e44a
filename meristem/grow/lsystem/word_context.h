// SPDX-License-Identifier: Apache-2.0
// Finds the neighbours of modules for contexts: along the axis that carries the module, without brackets and ignored
// letters.
//
// Based on: P. Prusinkiewicz, A. Lindenmayer: The Algorithmic Beauty of Plants (1990), section 1.8. The book does not
// define a context that names a branch if there are several branches in a row. This implementation uses the first one
// that matches.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/grow/lsystem/grammar.h"

namespace meristem {

inline constexpr std::uint32_t kNoModule = std::numeric_limits<std::uint32_t>::max();

/// The kinds of neighbours that some rules use. Each kind costs 4 bytes per module.
struct ContextNeeds {
  bool left = false;
  bool right = false;
  bool branches = false;  ///< a right context contains a branch

  bool any() const { return left || right; }
};

ContextNeeds context_needs(const Grammar& grammar, const RuleSet& set);

class WordContext {
 public:
  /// Finds the neighbours in `letters`, which must outlive the matching. Cost: linear, with a stack as deep as the
  /// brackets.
  void find(const Grammar& grammar, std::span<const LetterIndex> letters, ContextNeeds needs, const Progress& progress);

  /// Returns true if the module at `position` matches the rule's contexts. Then `matched` contains the positions of the
  /// left context's modules, followed by the right context's positions. Brackets have no entry.
  bool matches(const GrammarRule& rule, std::uint32_t position, std::vector<std::uint32_t>& matched) const;

 private:
  void find_left(const Grammar& grammar, const Progress& progress);
  void find_right(const Grammar& grammar, const Progress& progress);
  void find_symbols(const Grammar& grammar, const Progress& progress);
  bool matches_left(const GrammarRule& rule, std::uint32_t position, std::uint32_t* matched) const;
  bool matches_right(const GrammarRule& rule, std::uint32_t position, std::uint32_t* matched) const;
  std::uint32_t next_symbol(std::uint32_t position) const;

  std::span<const LetterIndex> letters_;
  const Grammar* grammar_ = nullptr;
  std::vector<std::uint32_t> left_;    // the previous module on its axis, or the one that its branch grows from
  std::vector<std::uint32_t> right_;   // the next module on its axis
  std::vector<std::uint32_t> symbol_;  // for [ its ]; for other modules the next letter or bracket that is not ignored
};

}  // namespace meristem
