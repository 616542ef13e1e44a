// SPDX-License-Identifier: Apache-2.0
// Evaluates expressions of a rule for many modules that it may replace.
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

/// Number of modules that one thread processes together.
inline constexpr std::size_t kChunk = 8'192;

/// Index of each module's first parameter.
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
  std::vector<std::uint32_t> blocks_;  // relative to the begin of their chunk
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
  std::uint32_t module = 0;  ///< position of the module
  std::size_t in = 0;        ///< its first parameter
  std::size_t out = 0;       ///< first parameter of its successor
};

/// Values of formulas for the modules of a batch. Memory is reused from batch to batch.
class RuleBatch {
 public:
  static constexpr std::size_t kLanes = 256;

  /// Starts a batch of at most kLanes lanes. All lanes must have the rule's predecessor and match its contexts.
  void begin(const OldWord& old, const RulePlan& plan, std::span<const Lane> lanes);
  /// Returns one value per lane, valid until the next call.
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
  std::vector<std::array<double, kLanes>> columns_;  // one column per variable
  std::vector<std::uint8_t> is_gathered_;
  std::vector<const double*> pointers_;
  std::vector<RandomKey> keys_;
  std::array<double, kLanes> results_;
};

}  // namespace meristem
