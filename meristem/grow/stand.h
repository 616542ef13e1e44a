// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "meristem/base/progress.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// One plant growing among others. A growth model implements it; a stand drives it.
class Grower {
 public:
  virtual ~Grower() = default;
  /// The most steps it will take; 0 for a member that does not grow.
  virtual int step_limit() const = 0;
  /// Grows one step. Returns whether it may grow further; once it does not, step() is not called again.
  virtual bool step(Progress& progress) = 0;
  /// The finished skeleton, post-processed, with radii, axes and orders; called once, after the last step.
  virtual Skeleton take_skeleton(Progress& progress) = 0;
};

/// Grows all members together, one step after another in their order, until none can grow further or all have reached
/// their step limits. Passes on what members throw: InputError when one exceeds its limits, Cancelled when asked to
/// stop.
void grow_stand(std::span<const std::unique_ptr<Grower>> members, Progress& progress);

}  // namespace meristem
