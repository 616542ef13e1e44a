// SPDX-License-Identifier: Apache-2.0
// Existing wood of a tree that continues to grow: converts a skeleton of any origin to metamers.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/grow/metamer/metamers.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// A metamer of existing wood.
struct WoodMetamer {
  MetamerIndex from = 0;  ///< the metamer that bears it: 0 is the seed, k + 1 is the k-th of the list
  bool is_lateral = false;
  Vec3 tip{0};               ///< metres from the root
  float radius = 0;          ///< metres, at the tip
  NodeIndex node = kNoNode;  ///< the node at its tip; kNoNode within an internode of the skeleton
};

/// Returns the metamers of a tree with one root, which is at the origin and becomes the seed. A metamer comes after the
/// metamer that bears it. If the skeleton has the column `bud_angle`, each node is one metamer and stays on its axis.
/// Otherwise nodes that are too close are removed first, and each internode is divided into equal metamers with a
/// length near `length`. The child on a node's own axis, or else the thickest child, continues from the terminal bud. A
/// metamer has one lateral bud. If a node has more laterals, short metamers before the next node bear the others.
std::vector<WoodMetamer> metamers_of_wood(const Skeleton& wood, double length);

/// Returns an upper bound for the number of metamers of a tree.
double max_metamers_of_wood(const Skeleton& wood, double length);

/// Properties of existing wood, by metamer.
class StandingWood {
 public:
  /// Stores the radii and tips of `metamers`, which must consist of the seed and `wood`.
  void stand(const Metamers& metamers, float seed_radius, const std::vector<WoodMetamer>& wood);
  void remove(const std::vector<std::uint8_t>& gone);
  /// Returns true if a metamer is existing wood.
  bool stands(MetamerIndex metamer) const { return metamer < radius_.size(); }
  /// Returns the radius of existing wood that now bears `tips` tips.
  double radius(MetamerIndex metamer, double tips, const PipeModel& model) const;
  /// Sets the radii of existing wood to its own radii, increased for the tips gained since. Other radii do not change.
  void thicken(Skeleton& skeleton, const PipeModel& model) const;

 private:
  std::vector<float> radius_;
  std::vector<float> tips_;  // number of tips at the begin
};

}  // namespace meristem
