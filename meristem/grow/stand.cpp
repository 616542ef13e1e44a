// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/stand.h"

#include <cstdint>
#include <vector>

namespace meristem {

void grow_stand(std::span<const std::unique_ptr<Grower>> members, Progress& progress) {
  std::vector<std::uint64_t> steps_left;
  std::uint64_t steps = 0;
  for (const auto& member : members) {
    steps_left.push_back(static_cast<std::uint64_t>(member->step_limit()));
    steps += steps_left.back();
  }
  progress.begin("growing", steps);
  // Let every member that may still grow take one step, round after round.
  bool any_grows = true;
  while (any_grows) {
    any_grows = false;
    for (std::size_t k = 0; k < members.size(); ++k) {
      if (steps_left[k] == 0) continue;
      const bool may_grow = members[k]->step(progress);
      // A member that ends early has done all of its share.
      const std::uint64_t done = may_grow ? 1 : steps_left[k];
      steps_left[k] -= done;
      progress.advance(done);
      any_grows = any_grows || steps_left[k] > 0;
    }
  }
}

}  // namespace meristem
