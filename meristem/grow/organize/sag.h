// SPDX-License-Identifier: Apache-2.0
// Branches bend under what they carry. Each internode is an elastic beam; what it bends under the load of an iteration
// stays when new wood is laid on, and only a change of the load bends it again, as stiff as it is then: more load
// further down, less of it back up.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/scene/directions.h"

namespace meristem {

struct Sag {
  double stiffness = 5;      ///< modulus of elasticity, gigapascals; green wood has 4 to 12
  double density = 900;      ///< of green wood, kilograms per cubic metre
  double leaf_mass = 0.002;  ///< kilograms that a metamer of the last iteration carries besides
};

/// How the metamers of a tree stand, by metamer.
struct Pose {
  std::vector<Vec3> tip;     ///< metres from the root
  std::vector<Vec3> side;    ///< unit vectors from the axis to the lateral bud
  std::vector<Vec3> moment;  ///< newton metres that each internode is bent for; empty for trees that do not sag
};

/// The load of a tree's branches and what it has bent.
class BranchLoad {
 public:
  /// The load of a tree with its root at `root`, whose weight pulls where `directions` say.
  BranchLoad(const Sag& sag, const PipeModel& radii, const Directions& directions = {}, Vec3 root = Vec3(0))
      : sag_(sag), radii_(radii), directions_(directions), root_(root) {}

  /// How the metamers stand once all internodes are bent by what their load has grown since the moments that were taken
  /// last; what goes on them moves and turns along. Shoots that are tied keep their form, and their load is borne by
  /// what they are tied to. Nothing comes below the ground, which is level at the root;
  /// obstacles are not asked. `iteration` is the newest.
  Pose bend(const Metamers& metamers, int iteration) const;
  /// What the internodes are bent for from now on; internodes beyond the end of `moment` are bent for nothing.
  void take(std::vector<Vec3> moment) { moment_ = std::move(moment); }
  /// Follows Metamers::remove().
  void remove(const std::vector<std::uint8_t>& gone);
  /// Makes it what a copy of it holds.
  void restore(BranchLoad copy) { moment_ = std::move(copy.moment_); }

 private:
  Sag sag_;
  PipeModel radii_;
  Directions directions_;
  Vec3 root_;
  std::vector<Vec3> moment_;  // newton metres about the base of each metamer, as it was bent
};

}  // namespace meristem
