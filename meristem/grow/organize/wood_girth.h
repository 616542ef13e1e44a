// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/grow/organize/standing_wood.h"
#include "meristem/plant/pipe_radii.h"

namespace meristem {

/// The thickness of a tree's wood at the time of construction, for queries of a few metamers.
class WoodGirth {
 public:
  /// Cost: linear in the tree. `standing` and `model` must outlive this object.
  WoodGirth(const Metamers& metamers, const StandingWood& standing, const PipeModel& model);
  /// Returns the radius at a metamer's end in metres: the skeleton's radius before callus.
  double radius(MetamerIndex metamer) const;

 private:
  const StandingWood& standing_;
  const PipeModel& model_;
  std::vector<double> tips_;
};

}  // namespace meristem
