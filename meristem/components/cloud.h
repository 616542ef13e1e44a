// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meristem/components/parts/crown_table.h"
#include "meristem/components/parts/limit_table.h"
#include "meristem/graph/component.h"

namespace meristem {

/// The attraction points of a crown as dots, to show a crown, a distribution, and the points that the scene removes. If
/// `of` names a tree, the component uses the tree's parameters.
struct Cloud : ComponentBase {
  std::string of;  ///< id of the tree; empty: the component has its own points
  std::optional<CrownParameters> crown;
  PointsParameters points;
  std::vector<Vec3> roots{Vec3(0)};    ///< as in the tree
  bool one_crown = false;              ///< as in the tree
  LightLimit limit;                    ///< limit on light, as in trees
  double size = 0.03;                  ///< diameter of a dot, metres
  bool after_growth = false;           ///< true: shows the points that the growth of `of` has left
  std::optional<Vec3> used_colour;     ///< colour of the dots that the tree has used up; unset: not shown
  std::optional<Vec3> removed_colour;  ///< colour of the dots that obstacles or the limit remove; unset: not shown
};

ComponentType cloud_component();

}  // namespace meristem
