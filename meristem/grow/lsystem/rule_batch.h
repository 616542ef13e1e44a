// SPDX-License-Identifier: Apache-2.0
// Expressions of a rule over many of the modules that it may replace.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/grow/lsystem/rule_plan.h"
#include "meristem/grow/lsystem/word.h"
#include "meristem/grow/lsystem/word_context.h"

namespace meristem {

/// Modules of a word that are dealt with together, by one thread.
inline constexpr std::size_t kChunk = 8'192;

/// Where the modules' parameters begin.
class ParameterOffsets {
 public:
  void find(const Word& word, std::span<const std::uint16_t> arities, const Progress& progress);
  std::size_t of_chunk(std::size_t chunk) const { return chunks_[chunk]; }
  std::size_t of_module(std::size_t position) const;

 private:
  static constexpr std::size_t kBlock = 64;

  const Word* word_ = nullptr;
  std::span<const std::uint16_t> arities_;
  std::vector<std::size_t> chunks_;
  std::vector<std::uint32_t> blocks_;  // from their chunk's beginning
};

/// A word that is being rewritten.
struct OldWord {
  const Word& word;
  const WordContext& context;
  const ParameterOffsets& places;
  RandomKey key;
};

/// A module that a rule may replace.
struct Lane {
  std::uint32_t module = 0;  ///< its position
  std::size_t in = 0;        ///< its first parameter
  std::size_t out = 0;       ///< its successor's first parameter
};

/// Values of formulas for the modules of a batch; memory is kept from one to the next.
class RuleBatch {
 public:
  static constexpr std::size_t kLanes = 256;

  /// At most kLanes lanes, all with the rule's predecessor and in its contexts.
  void begin(const OldWord& old, const RulePlan& plan, std::span<const Lane> lanes);
  /// A value per lane; they hold until the next call.
  std::span<const double> values(const RuleFormula& formula);
  std::span<const double> values(const VariableSource& source);

 private:
  void find_matched();

  const OldWord* old_ = nullptr;
  const RulePlan* plan_ = nullptr;
  std::span<const Lane> lanes_;
  bool has_matched_ = false;
  std::vector<std::size_t> matched_;  // first parameter of each lane's context modules, lane after lane
  std::vector<std::uint32_t> matched_of_lane_;
  std::vector<std::array<double, kLanes>> columns_;  // one per variable
  std::vector<std::uint8_t> is_gathered_;
  std::vector<const double*> pointers_;
  std::vector<RandomKey> keys_;
  std::array<double, kLanes> results_;
};

}  // namespace meristem
