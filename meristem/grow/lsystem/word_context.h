// SPDX-License-Identifier: Apache-2.0
// Neighbours of a word's modules as contexts see them: along the axis that carries them, over the brackets and over
// ignored letters.
//
// Based on: P. Prusinkiewicz, A. Lindenmayer: The Algorithmic Beauty of Plants (1990), section 1.8. It is silent about
// a context that names a branch where several stand in a row: here the first of them that matches is taken.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/grow/lsystem/grammar.h"

namespace meristem {

inline constexpr std::uint32_t kNoModule = std::numeric_limits<std::uint32_t>::max();

/// Which neighbours the contexts of some rules ask for; each kind costs 4 bytes per module.
struct ContextNeeds {
  bool left = false;
  bool right = false;
  bool branches = false;  ///< a right context names a branch

  bool any() const { return left || right; }
};

ContextNeeds context_needs(const Grammar& grammar, const RuleSet& set);

class WordContext {
 public:
  /// Finds the neighbours in `letters`, which must outlive the matching. Linear in their number, with a stack as deep
  /// as the brackets.
  void find(const Grammar& grammar, std::span<const LetterIndex> letters, ContextNeeds needs, const Progress& progress);

  /// Whether the module at `position` stands in the rule's contexts. If so, `matched` has the positions of the left
  /// context's modules and then those of the right context's; brackets have none.
  bool matches(const Rule& rule, std::uint32_t position, std::vector<std::uint32_t>& matched) const;

 private:
  void find_left(const Grammar& grammar, const Progress& progress);
  void find_right(const Grammar& grammar, const Progress& progress);
  void find_symbols(const Grammar& grammar, const Progress& progress);
  bool matches_left(const Rule& rule, std::uint32_t position, std::uint32_t* matched) const;
  bool matches_right(const Rule& rule, std::uint32_t position, std::uint32_t* matched) const;
  std::uint32_t next_symbol(std::uint32_t position) const;

  std::span<const LetterIndex> letters_;
  const Grammar* grammar_ = nullptr;
  std::vector<std::uint32_t> left_;    // the module before it on its axis, or where its branch stands
  std::vector<std::uint32_t> right_;   // the module after it on its axis
  std::vector<std::uint32_t> symbol_;  // of [ its ]; of others the next letter or bracket that is not ignored
};

}  // namespace meristem
