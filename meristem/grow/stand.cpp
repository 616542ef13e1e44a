// SPDX-License-Identifier: Apache-2.0
// The loop over rounds: all members step in parallel, then report in order. See stand.h.
#include "meristem/grow/stand.h"

#include <cstdint>

#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kMaxBlocks = 256;  // blocks of members per parallel loop, at most

std::size_t grain_of(std::size_t members) { return 1 + members / kMaxBlocks; }

}  // namespace

void Stand::grow(Progress& progress) {
  std::vector<std::uint64_t> steps_left;
  std::vector<std::size_t> growing;
  std::uint64_t steps = 0;
  for (std::size_t k = 0; k < members_.size(); ++k) {
    steps_left.push_back(static_cast<std::uint64_t>(members_[k]->step_limit()));
    steps += steps_left.back();
    if (steps_left.back() > 0) growing.push_back(k);
  }
  progress.begin("growing", steps);
  std::vector<std::uint8_t> may_grow(members_.size(), 0);
  while (!growing.empty()) {
    for (const Shared& shared : commons_) shared.commons->begin_round(progress);
    // Let every member that may still grow take one step in parallel.
    parallel_for(growing.size(), grain_of(growing.size()), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) may_grow[growing[k]] = members_[growing[k]]->step(progress) ? 1 : 0;
    });
    for (const std::size_t k : growing) {
      members_[k]->tell();
      // A member that ends early has completed all of its remaining steps.
      const std::uint64_t done = may_grow[k] != 0 ? 1 : steps_left[k];
      steps_left[k] -= done;
      progress.advance(done);
    }
    std::erase_if(growing, [&](std::size_t k) { return steps_left[k] == 0; });
  }
}

/// Executes the plans of all members that record their outcome, at the same time, and computes the result.
void Stand::see_outcomes(Progress& progress) {
  std::vector<Grower*> planners;
  for (const std::unique_ptr<Grower>& member : members_) {
    if (member->do_plan(progress)) planners.push_back(member.get());
  }
  if (planners.empty()) return;
  for (Grower* const planner : planners) planner->tell();
  for (const Shared& shared : commons_) shared.commons->begin_round(progress);
  for (Grower* const planner : planners) planner->see_outcome(progress);
}

std::vector<std::unique_ptr<GrowthTrace>> Stand::take_traces(Progress& progress) {
  for (const Shared& shared : commons_) shared.commons->end_record(progress);
  see_outcomes(progress);
  std::vector<std::unique_ptr<GrowthTrace>> traces;
  traces.reserve(members_.size());
  for (const std::unique_ptr<Grower>& member : members_) {
    traces.push_back(member->take_trace());
    if (traces.back() != nullptr) traces.back()->place = member->place;
  }
  return traces;
}

std::vector<Skeleton> Stand::take_skeletons(Progress& progress) {
  commons_.clear();  // free memory before finishing, which no longer needs the commons
  std::vector<Skeleton> skeletons(members_.size());
  parallel_for(members_.size(), grain_of(members_.size()), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      skeletons[k] = members_[k]->take_skeleton(progress);
      members_[k].reset();
    }
  });
  return skeletons;
}

}  // namespace meristem
