// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/plant/plant.h"

namespace meristem {

/// A stem before joining, and the place on another stem where it grows.
struct LooseStem {
  StemPart part;                                    ///< the component instance that made the stem
  std::shared_ptr<const Skeleton> skeleton;         ///< never null
  std::shared_ptr<Skeleton> own{};                  ///< the skeleton if nobody else uses it, so that it may be moved;
                                                    ///< else null
  std::uint32_t parent = kNoStem;                   ///< index of an earlier stem in the list, or kNoStem
  NodeIndex node = 0;                               ///< the stem grows on the parent's segment that ends in this node
  float along = 1;                                  ///< position on that segment, 0 at its begin to 1 at its end
  std::vector<std::uint32_t> individual_of_root{};  ///< as in Stem; ignored for stems that join others
  std::uint64_t name = 0;                           ///< names of the axes are derived from it
  /// The number that each axis contributes to its name. If empty, the axis's own number.
  std::vector<AxisIndex> number_of_axis{};
};

/// Joins stems to their parent stems. The parent gets a node at each place where children begin, and that node replaces
/// the children's roots. The children's axes become laterals of the parent, and their orders continue from it. A stem
/// stays separate if it has no root or several roots. It also stays separate if it begins farther from its site than
/// `reach` radii of the parent there.
///
/// Returns the joined stems in the order of their roots in the list. Axes are numbered by their first nodes. Cost:
/// linear, plus sorting the children of each segment.
std::vector<Stem> join_stems(std::vector<LooseStem> stems, float reach = 3);

}  // namespace meristem
