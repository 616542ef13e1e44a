// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// One plant growing among others. A growth model implements it; a stand drives it.
class Grower {
 public:
  virtual ~Grower() = default;
  /// Upper bound of the steps it will ask for, for progress.
  virtual int step_limit() const = 0;
  /// Grows one step. Returns whether it may grow further; afterwards step() is not called again.
  virtual bool step(Progress& progress) = 0;
  /// The finished skeleton, post-processed, with radii, axes and orders; called once, after the last step.
  virtual Skeleton take_skeleton(Progress& progress) = 0;
};

/// Grows all members together, one step after another in their order, until none can grow further.
/// Throws InputError when the members' nodes exceed their limits, Cancelled when asked to stop.
void grow_stand(std::span<const std::unique_ptr<Grower>> members, Progress& progress);

}  // namespace meristem
