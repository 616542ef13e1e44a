// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/mesh.h"

namespace meristem {

struct HullEdge {
  Vec3 from{0};
  Vec3 to{0};
};

/// Returns the edges of a convex hull, each once. Edges between triangles in one plane are left out.
std::vector<HullEdge> hull_edges(const Mesh& hull);

}  // namespace meristem
