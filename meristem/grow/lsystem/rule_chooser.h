// SPDX-License-Identifier: Apache-2.0
// Chooses the rule for each module of a chunk. A rule is tested on all candidate modules together, so that its
// expressions run over many lanes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/grow/lsystem/rule_batch.h"
#include "meristem/grow/lsystem/rule_plan.h"

namespace meristem {

/// Lives of words in continuous time. Modules are replaced if their lives end by the time `until`.
struct LifeSpan {
  double until = 0;
  std::span<double> ends;  ///< output: the end of each life, by position
};

class RuleChooser {
 public:
  /// Writes the choices of the modules from `begin` to `end`, a chunk, to their positions in `choices`. Returns true if
  /// the letter alone does not decide the choice of some module. Throws InputError for invalid weights and lives.
  /// Throws Cancelled.
  bool choose(const RewritePlan& plan, const OldWord& old, std::span<const std::uint16_t> arities, std::size_t begin,
              std::size_t end, std::span<RuleChoice> choices, const std::optional<LifeSpan>& lives,
              const Progress& progress);

 private:
  /// A module whose rule is not known yet.
  struct Candidate {
    Lane lane;
    double weight = 0;  ///< sum of the weights of the tested rules; above 0 if a rule must be drawn
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
  std::vector<LetterIndex> letters_;                // letters that have candidates
  std::vector<std::uint32_t> matching_;             // candidates that the rule matches so far
  std::vector<std::uint32_t> matched_;
  std::vector<Lane> lanes_;
  RuleBatch batch_;
};

}  // namespace meristem
