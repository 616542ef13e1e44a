// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "meristem/base/mesh.h"
#include "meristem/base/vec.h"

namespace meristem {

/// Returns the polygon as triangles in its organ's frame (y along, z up). Front faces look up, normals are at right
/// angles to the best fitting plane, and uvs span the polygon's box in that plane, v along y. Corners need not lie in a
/// plane, and are not moved. Repeated corners count once. Returns an empty mesh if the polygon has no area. If it
/// crosses itself, the result has holes or covers parts twice. The cost grows with the square of the corners: 64 take
/// 0.1 ms.
Mesh make_polygon(std::span<const Vec3> corners);

}  // namespace meristem
