// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/grow/organize/standing_wood.h"
#include "meristem/plant/pipe_radii.h"

namespace meristem {

/// How thick a tree's wood is, for those who ask about few of its metamers. It stays as the tree was when it was made.
class WoodGirth {
 public:
  /// Time goes with the tree. `standing` and `model` outlive it.
  WoodGirth(const Metamers& metamers, const StandingWood& standing, const PipeModel& model);
  /// Metres, at a metamer's end: the radius that the skeleton has there, before callus.
  double radius(MetamerIndex metamer) const;

 private:
  const StandingWood& standing_;
  const PipeModel& model_;
  std::vector<double> tips_;
};

}  // namespace meristem
