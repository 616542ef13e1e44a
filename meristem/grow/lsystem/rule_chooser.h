// SPDX-License-Identifier: Apache-2.0
// Which rule applies to each module of a chunk. A rule is tried on all modules that may still take it at once, so that
// its expressions run over many lanes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/grow/lsystem/rule_batch.h"
#include "meristem/grow/lsystem/rule_plan.h"

namespace meristem {

/// Lives of words in continuous time: modules are replaced that come to the end of theirs by a time.
struct LifeSpan {
  double until = 0;
  std::span<double> ends;  ///< takes when those do, by position
};

class RuleChooser {
 public:
  /// Writes the choices of the modules from `begin` to `end`, a chunk, to their positions in `choices`. Returns whether
  /// any module's letter was not enough to tell. Throws InputError for weights and lives that are none, and Cancelled.
  bool choose(const RewritePlan& plan, const OldWord& old, std::span<const std::uint16_t> arities, std::size_t begin,
              std::size_t end, std::span<RuleChoice> choices, const std::optional<LifeSpan>& lives,
              const Progress& progress);

 private:
  /// A module whose rule is not known yet.
  struct Candidate {
    Lane lane;
    double weight = 0;  ///< of all rules to draw from that were tried; more than 0 if one is to be drawn
    bool is_decided = false;
  };

  void decide(const RewritePlan& plan, const OldWord& old, LetterIndex letter, std::span<RuleChoice> choices,
              const std::optional<LifeSpan>& lives, const Progress& progress);
  void decide_by_life(const OldWord& old, const RulePlan& plan, RuleChoice choice, std::vector<Candidate>& candidates,
                      std::span<RuleChoice> choices, const LifeSpan& lives);
  void keep_in_context(const OldWord& old, const RulePlan& plan, const std::vector<Candidate>& candidates);
  void keep_where_true(const OldWord& old, const RulePlan& plan, const std::vector<Candidate>& candidates);
  void draw(const OldWord& old, const RulePlan& plan, RuleChoice choice, std::vector<Candidate>& candidates,
            std::span<RuleChoice> choices);
  void begin_batch(const OldWord& old, const RulePlan& plan, const std::vector<Candidate>& candidates,
                   std::span<const std::uint32_t> batch);

  std::vector<std::vector<Candidate>> candidates_;  // by letter
  std::vector<LetterIndex> letters_;                // those that have any
  std::vector<std::uint32_t> matching_;             // candidates that the rule matches, as far as it was tried
  std::vector<std::uint32_t> matched_;
  std::vector<Lane> lanes_;
  RuleBatch batch_;
};

}  // namespace meristem
