// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/stand.h"

#include <cstdint>

namespace meristem {

void Stand::grow(Progress& progress) {
  std::vector<std::uint64_t> steps_left;
  std::uint64_t steps = 0;
  for (const auto& member : members_) {
    steps_left.push_back(static_cast<std::uint64_t>(member->step_limit()));
    steps += steps_left.back();
  }
  progress.begin("growing", steps);
  // Let every member that may still grow take one step, round after round.
  bool any_grows = steps > 0;
  while (any_grows) {
    any_grows = false;
    for (const Shared& shared : commons_) shared.commons->begin_round(progress);
    for (std::size_t k = 0; k < members_.size(); ++k) {
      if (steps_left[k] == 0) continue;
      const bool may_grow = members_[k]->step(progress);
      // A member that ends early has done all of its share.
      const std::uint64_t done = may_grow ? 1 : steps_left[k];
      steps_left[k] -= done;
      progress.advance(done);
      any_grows = any_grows || steps_left[k] > 0;
    }
  }
}

std::vector<Skeleton> Stand::take_skeletons(Progress& progress) {
  commons_.clear();  // finishing needs memory, and nothing of what they competed for
  std::vector<Skeleton> skeletons;
  for (std::unique_ptr<Grower>& member : members_) {
    skeletons.push_back(member->take_skeleton(progress));
    member.reset();
  }
  return skeletons;
}

}  // namespace meristem
