// SPDX-License-Identifier: Apache-2.0
// Wood that stood before a tree goes on growing: a skeleton of any origin, as metamers.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// A metamer of a tree that stands already.
struct WoodMetamer {
  MetamerIndex from = 0;  ///< the metamer that bears it: 0 is the seed, k + 1 the k-th of the list
  bool is_lateral = false;
  Vec3 tip{0};               ///< metres from the root
  float radius = 0;          ///< metres, at the tip
  NodeIndex node = kNoNode;  ///< the node at its tip; kNoNode within an internode of the skeleton
};

/// The metamers of a tree with one root, which stands at the origin and is the seed. A metamer comes after the one that
/// bears it. Where the column `bud_angle` says that the nodes are metamers, each node is one metamer and stays on its
/// axis. In all other trees an internode is as many equal metamers as come nearest to `length`, and nodes closer
/// together are thinned out first. The child on a node's own axis, or where there is none the thickest child, goes on
/// from the terminal bud. A metamer has one lateral bud: where a node bears more laterals, short metamers before the
/// next node bear the others.
std::vector<WoodMetamer> metamers_of_wood(const Skeleton& wood, double length);

/// The largest number of metamers that can be made of a tree.
double most_metamers_of_wood(const Skeleton& wood, double length);

/// What is remembered of wood that stood already, by metamer.
class StandingWood {
 public:
  /// Remembers the radii and tips of `metamers`, which are the seed and `wood` and no more.
  void stand(const Metamers& metamers, float seed_radius, const std::vector<WoodMetamer>& wood);
  void remove(const std::vector<std::uint8_t>& gone);
  /// Whether a metamer stood already.
  bool stands(MetamerIndex metamer) const { return metamer < radius_.size(); }
  /// The radius of one that did, now that it bears this number of tips.
  double radius(MetamerIndex metamer, double tips, const PipeModel& model) const;
  /// Gives wood that stood already its own radii, which grow by the tips that it has gained since; all other radii
  /// stay.
  void thicken(Skeleton& skeleton, const PipeModel& model) const;

 private:
  std::vector<float> radius_;
  std::vector<float> tips_;  // that it bore
};

}  // namespace meristem
