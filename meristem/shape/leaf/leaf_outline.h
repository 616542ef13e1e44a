// SPDX-License-Identifier: Apache-2.0
// From a blade's parameters to its flat outline.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "meristem/shape/leaf/leaf_blade.h"

namespace meristem {

/// The right half of a blade that lies flat. x counts in half widths from the midrib, y in lengths from the joint.
struct LeafOutline {
  std::vector<glm::dvec2> edge;  ///< from the joint (0, 0) to the tip (0, 1); a hull starts and ends at low and high
  std::vector<double> rows;      ///< where the mesh is cut across, rising
  double low = 0;                ///< lower end of the whole outline along
  double high = 1;               ///< upper end of the whole outline along
};

/// As fine as its parameters say: the edge with all its teeth. Without rows.
LeafOutline full_outline(const LeafBlade& blade);

/// As coarse as the mesh is to be.
LeafOutline mesh_outline(const LeafBlade& blade);

/// Whether the polygon of `blade`, closed along the midrib, touches or crosses itself.
bool polygon_crosses_itself(const LeafBlade& blade);

}  // namespace meristem
