// SPDX-License-Identifier: Apache-2.0
// Chooses rules for a chunk. Candidates are grouped by letter, and each rule's context, condition and weight is tested
// for all candidates of its letter together.
#include "meristem/grow/lsystem/rule_chooser.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "meristem/base/in_quotes.h"
#include "meristem/grow/lsystem/rule_errors.h"

namespace meristem {

namespace {

/// Calls `body` for consecutive parts of `all` that fit into a batch.
template <typename Body>
void for_each_batch(std::span<const std::uint32_t> all, Body body) {
  for (std::size_t begin = 0; begin < all.size(); begin += RuleBatch::kLanes) {
    body(all.subspan(begin, std::min(RuleBatch::kLanes, all.size() - begin)));
  }
}

}  // namespace

/// Chooses in two steps. First, each module gets the choice that its letter alone decides: a rule, or to be copied. A
/// module whose rules have contexts, conditions, weights or lives becomes a candidate of its letter. Then the rules of
/// each letter are tested in their order, each on all remaining candidates. The first rule without a weight that
/// matches a candidate decides it. One of the matching rules with weights is drawn. A candidate that no rule matches is
/// copied.
bool RuleChooser::choose(const RewritePlan& plan, const OldWord& old, std::span<const std::uint16_t> arities,
                         std::size_t begin, std::size_t end, std::span<RuleChoice> choices,
                         const std::optional<LifeSpan>& lives, const Progress& progress) {
  for (const LetterIndex letter : letters_) candidates_[letter].clear();
  letters_.clear();
  candidates_.resize(plan.by_letter.size());
  const LetterIndex* const letters = old.word.letters.data();

  // Let the letters decide, and collect the candidates.
  if (plan.is_decided) {
    for (std::size_t k = begin; k < end; ++k) choices[k] = plan.by_letter[letters[k]];
    return false;
  }
  std::size_t in = old.places.of_chunk(begin / kChunk);
  for (std::size_t k = begin; k < end; ++k) {
    const LetterIndex letter = letters[k];
    choices[k] = plan.by_letter[letter];
    if (choices[k] == kUndecided) {
      choices[k] = kCopied;
      std::vector<Candidate>& candidates = candidates_[letter];
      if (candidates.empty()) letters_.push_back(letter);
      candidates.push_back({{static_cast<std::uint32_t>(k), in, 0}, 0, false});
    }
    in += arities[letter];
  }

  // Test the rules of each letter on its candidates.
  for (const LetterIndex letter : letters_) decide(plan, old, letter, choices, lives, progress);
  return !letters_.empty();
}

/// Tests the rules of one letter in their order, until no candidate is left.
void RuleChooser::decide(const RewritePlan& plan, const OldWord& old, LetterIndex letter, std::span<RuleChoice> choices,
                         const std::optional<LifeSpan>& lives, const Progress& progress) {
  std::vector<Candidate>& candidates = candidates_[letter];
  for (const std::uint32_t index : plan.set->of_letter[letter]) {
    if (candidates.empty()) return;
    progress.check();
    const RulePlan& rule = plan.rules[index];
    // If weighted rules match, a later rule without a weight does not apply.
    matching_.clear();
    for (std::uint32_t k = 0; k < candidates.size(); ++k) {
      if (rule.weight || candidates[k].weight == 0) matching_.push_back(k);
    }
    if (rule.has_context) keep_in_context(old, rule, candidates);
    if (rule.condition) keep_where_true(old, rule, candidates);
    const RuleChoice choice = rule.is_identity ? kCopied : static_cast<RuleChoice>(index + 1);
    if (rule.weight) {
      draw(old, rule, choice, candidates, choices);
      continue;
    }
    if (lives && rule.life) {
      decide_by_life(old, rule, choice, candidates, choices, *lives);
    } else {
      for (const std::uint32_t k : matching_) choices[candidates[k].lane.module] = choice;
    }
    for (const std::uint32_t k : matching_) candidates[k].is_decided = true;
    std::erase_if(candidates, [](const Candidate& candidate) { return candidate.is_decided; });
  }
}

void RuleChooser::keep_in_context(const OldWord& old, const RulePlan& plan, const std::vector<Candidate>& candidates) {
  std::erase_if(matching_,
                [&](std::uint32_t k) { return !old.context.matches(*plan.rule, candidates[k].lane.module, matched_); });
}

void RuleChooser::keep_where_true(const OldWord& old, const RulePlan& plan, const std::vector<Candidate>& candidates) {
  std::size_t kept = 0;
  for_each_batch(matching_, [&](std::span<const std::uint32_t> batch) {
    begin_batch(old, plan, candidates, batch);
    const std::span<const double> values = batch_.values(*plan.condition);
    // Writing in place is safe: the write position never passes the read position.
    for (std::size_t lane = 0; lane < batch.size(); ++lane) {
      if (!std::isfinite(values[lane])) {
        throw_rule_error(*plan.rule, fmt::format("the condition of {} has no value", in_quotes(plan.rule->text)),
                         "a condition that does not divide by zero or the like");
      }
      if (values[lane] != 0) matching_[kept++] = batch[lane];
    }
  });
  matching_.resize(kept);
}

/// Chooses the first matching rule of a module, and replaces the module only if its life is over.
void RuleChooser::decide_by_life(const OldWord& old, const RulePlan& plan, RuleChoice choice,
                                 std::vector<Candidate>& candidates, std::span<RuleChoice> choices,
                                 const LifeSpan& lives) {
  for_each_batch(matching_, [&](std::span<const std::uint32_t> batch) {
    begin_batch(old, plan, candidates, batch);
    const std::span<const double> values = batch_.values(*plan.life);
    for (std::size_t lane = 0; lane < batch.size(); ++lane) {
      if (!(values[lane] > 0)) {
        throw_rule_error(*plan.rule,
                         fmt::format("the life {} in {} is {:.6g}", in_quotes(plan.life->expression.text()),
                                     in_quotes(plan.rule->text), values[lane]),
                         "a life above 0");
      }
      const std::uint32_t module = candidates[batch[lane]].lane.module;
      const double end = old.word.births[module] + values[lane];
      if (!(end <= lives.until)) continue;
      choices[module] = choice;
      lives.ends[module] = end;
    }
  });
}

void RuleChooser::draw(const OldWord& old, const RulePlan& plan, RuleChoice choice, std::vector<Candidate>& candidates,
                       std::span<RuleChoice> choices) {
  for_each_batch(matching_, [&](std::span<const std::uint32_t> batch) {
    begin_batch(old, plan, candidates, batch);
    const std::span<const double> weights = batch_.values(*plan.weight);
    require_weights(weights, *plan.rule, *plan.weight);
    for (std::size_t lane = 0; lane < batch.size(); ++lane) {
      if (weights[lane] == 0) continue;
      Candidate& candidate = candidates[batch[lane]];
      candidate.weight += weights[lane];
      // Weighted sampling in one pass: each rule replaces the earlier choice with the probability of its share of the
      // weights so far. In the end, probabilities are proportional to the weights.
      const bool is_first = candidate.weight == weights[lane];
      const RandomKey key = old.key.child(candidate.lane.module).child(std::uint64_t{0});
      if (is_first || key.uniform(plan.index) * candidate.weight < weights[lane])
        choices[candidate.lane.module] = choice;
    }
  });
}

void RuleChooser::begin_batch(const OldWord& old, const RulePlan& plan, const std::vector<Candidate>& candidates,
                              std::span<const std::uint32_t> batch) {
  lanes_.clear();
  for (const std::uint32_t k : batch) lanes_.push_back(candidates[k].lane);
  batch_.begin(old, plan, lanes_);
}

}  // namespace meristem
