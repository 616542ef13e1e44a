// SPDX-License-Identifier: Apache-2.0
// Computes a blade's flat outline from its parameters.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "meristem/shape/leaf/leaf_blade.h"

namespace meristem {

/// The right half of a flat blade. x is in half widths from the midrib, y in lengths from the joint.
struct LeafOutline {
  std::vector<glm::dvec2> edge;  ///< from the joint (0, 0) to the tip (0, 1); a hull starts and ends at low and high
  std::vector<double> rows;      ///< positions where the mesh is cut across, ascending
  double low = 0;                ///< lower end of the whole outline along y
  double high = 1;               ///< upper end of the whole outline along y
};

/// Returns the outline in full detail, with all teeth of the edge and without rows.
LeafOutline full_outline(const LeafBlade& blade);

/// Returns the outline in the detail of the mesh.
LeafOutline mesh_outline(const LeafBlade& blade);

/// Returns true if the polygon of `blade`, closed along the midrib, touches or crosses itself.
bool polygon_crosses_itself(const LeafBlade& blade);

}  // namespace meristem
