// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

struct HullEdge {
  Vec3 from{0};
  Vec3 to{0};
};

/// Returns the edges of a convex hull, each once. Edges between triangles in one plane are left out.
std::vector<HullEdge> hull_edges(const Mesh& hull);

/// Returns the convex hull of each tree's crown, as measure_form() defines it. If no stem of an individual forks, its
/// limbs are stems of their own. Its crown then consists of the nodes above the lowest node of these limbs. Plants
/// without a hull, such as a single pole, give nothing. Throws Cancelled.
std::vector<Mesh> crown_hulls(const Plant& plant, const Progress& progress);

}  // namespace meristem
