// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meristem/components/parts/crown_table.h"
#include "meristem/components/parts/limit_table.h"
#include "meristem/graph/component.h"

namespace meristem {

/// The attraction points of a crown as dots, to see what a crown or a distribution is before a tree grows into it, and
/// what the scene leaves of it. Where it shows those of a tree, the tree's description is read as its own.
struct Cloud : ComponentBase {
  std::string of;  ///< id of the tree; empty: points of its own
  std::optional<CrownParameters> crown;
  PointsParameters points;
  std::vector<Vec3> roots{Vec3(0)};    ///< as of the tree
  bool one_crown = false;              ///< as of the tree
  LightLimit limit;                    ///< on light, as trees have it
  double size = 0.03;                  ///< metres across a dot
  bool after_growth = false;           ///< the points that growth has left, where `of` names a tree
  std::optional<Vec3> used_colour;     ///< of the dots that the tree has used up by then; unset: they are not shown
  std::optional<Vec3> removed_colour;  ///< of the dots that obstacles or the limit remove; unset: they are not shown
};

ComponentType cloud_component();

}  // namespace meristem
