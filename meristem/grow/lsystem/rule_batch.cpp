// SPDX-License-Identifier: Apache-2.0
// Gathers the variables of a formula for many modules into columns, and evaluates the formula over whole columns.
#include "meristem/grow/lsystem/rule_batch.h"

#include <algorithm>

#include "meristem/base/parallel.h"

namespace meristem {

void ParameterOffsets::find(const Word& word, std::span<const std::uint16_t> arities, const Progress& progress) {
  word_ = &word;
  arities_ = arities;
  const std::size_t count = word.letters.size();
  chunks_.assign((count + kChunk - 1) / kChunk + 1, 0);
  blocks_.resize((count + kBlock - 1) / kBlock);
  parallel_for(count, kChunk, [&](std::size_t begin, std::size_t end) {
    progress.check();
    std::uint32_t parameters = 0;
    for (std::size_t k = begin; k < end; k += kBlock) {
      blocks_[k / kBlock] = parameters;
      const std::size_t block_end = std::min(end, k + kBlock);
      for (std::size_t j = k; j < block_end; ++j) parameters += arities[word.letters[j]];
    }
    chunks_[begin / kChunk + 1] = parameters;
  });
  for (std::size_t k = 1; k < chunks_.size(); ++k) chunks_[k] += chunks_[k - 1];
}

std::size_t ParameterOffsets::of_module(std::size_t position) const {
  std::size_t place = chunks_[position / kChunk] + blocks_[position / kBlock];
  for (std::size_t k = position / kBlock * kBlock; k < position; ++k) place += arities_[word_->letters[k]];
  return place;
}

void RuleBatch::begin(const OldWord& old, const RulePlan& plan, std::span<const Lane> lanes) {
  old_ = &old;
  plan_ = &plan;
  lanes_ = lanes;
  has_matched_ = false;
  const std::size_t variables = plan.rule->variable_count;
  if (columns_.size() < variables) columns_.resize(variables);
  if (pointers_.size() < variables) pointers_.resize(variables);
  is_gathered_.assign(variables, 0);
}

std::span<const double> RuleBatch::values(const VariableSource& source) {
  std::array<double, kLanes>& column = columns_[source.variable];
  if (is_gathered_[source.variable] == 0) {
    const double* const parameters = old_->word.parameters.data() + source.parameter;
    if (source.module == VariableSource::kAge) {
      const auto& births = old_->word.births;
      for (std::size_t k = 0; k < lanes_.size(); ++k) column[k] = old_->word.time - births[lanes_[k].module];
    } else if (source.module == 0) {
      for (std::size_t k = 0; k < lanes_.size(); ++k) column[k] = parameters[lanes_[k].in];
    } else {
      if (!has_matched_) find_matched();
      const std::size_t stride = plan_->rule->left.size() + plan_->rule->right.size();
      const std::size_t* const places = matched_.data() + (source.module - 1);
      for (std::size_t k = 0; k < lanes_.size(); ++k) column[k] = parameters[places[k * stride]];
    }
    is_gathered_[source.variable] = 1;
  }
  return std::span(column).first(lanes_.size());
}

std::span<const double> RuleBatch::values(const RuleFormula& formula) {
  for (const VariableSource& source : formula.sources) pointers_[source.variable] = values(source).data();
  keys_.clear();
  if (formula.expression.is_random()) {
    for (const Lane& lane : lanes_) keys_.push_back(old_->key.child(lane.module).child(formula.stream));
  }
  const std::span<const double* const> variables(pointers_.data(), plan_->rule->variable_count);
  formula.expression.evaluate(lanes_.size(), variables, keys_, results_.data());
  return std::span(results_).first(lanes_.size());
}

void RuleBatch::find_matched() {
  matched_.clear();
  for (const Lane& lane : lanes_) {
    old_->context.matches(*plan_->rule, lane.module, matched_of_lane_);
    for (const std::uint32_t module : matched_of_lane_) {
      matched_.push_back(module == kNoModule ? 0 : old_->places.of_module(module));
    }
  }
  has_matched_ = true;
}

}  // namespace meristem
