// SPDX-License-Identifier: Apache-2.0
// Bending of branches under their load. Each internode is an elastic beam. Its deformation in an iteration becomes
// permanent when new wood grows. Only a change of the load bends it again, with its stiffness at that time: down for
// more load, up for less.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/scene/directions.h"

namespace meristem {

/// The wood and the load of branches.
struct BranchSag {
  double stiffness = 5;      ///< modulus of elasticity, gigapascals; green wood has 4 to 12; larger: less bending
  double density = 900;      ///< density of green wood, kilograms per cubic metre
  double leaf_mass = 0.002;  ///< additional mass of each metamer of the last iteration, kilograms
};

/// Positions and directions of the metamers of a tree.
struct TreePose {
  std::vector<Vec3> tip;   ///< metres from the root
  std::vector<Vec3> side;  ///< unit vectors from the axis to the lateral bud
  /// Bending moment that each internode has yielded to, newton metres; empty for trees that do not sag.
  std::vector<Vec3> moment;
};

/// The load of a tree's branches and the bending that it has caused.
class BranchLoad {
 public:
  /// The load of a tree with its root at `root`. `directions` defines gravity.
  BranchLoad(const BranchSag& sag, const PipeModel& radii, const Directions& directions = {}, Vec3 root = Vec3(0))
      : sag_(sag), radii_(radii), directions_(directions), root_(root) {}

  /// Returns the metamers after bending all internodes by the increase of their load since take(). Everything on an
  /// internode moves and turns with it. Tied shoots keep their form, and their support bears their load. No metamer of
  /// a free shoot moves below the ground, which is horizontal at the root. An internode turns by at most 0.35 radians
  /// per call, and an internode at the ground may change its length. Obstacles are ignored. `iteration` is the newest.
  TreePose bend(const Metamers& metamers, int iteration) const;
  /// Sets the moments that internodes have yielded to; missing entries are 0.
  void take(std::vector<Vec3> moment) { moment_ = std::move(moment); }
  /// Updates the indices after Metamers::remove().
  void remove(const std::vector<std::uint8_t>& gone);
  /// Restores the state of a copy.
  void restore(BranchLoad copy) { moment_ = std::move(copy.moment_); }

 private:
  BranchSag sag_;
  PipeModel radii_;
  Directions directions_;
  Vec3 root_;
  std::vector<Vec3> moment_;  // newton metres about the base of each metamer
};

}  // namespace meristem
