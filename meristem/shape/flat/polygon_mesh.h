// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "meristem/base/mesh.h"
#include "meristem/base/vec.h"

namespace meristem {

/// The polygon in triangles, in its organ's frame (y along, z up): front faces look up, normals are those of the plane
/// that fits it best, and uvs span its box in that plane, v along y. Corners need not lie in a plane and stay where
/// they are; those that repeat the one before count once. Empty where the polygon has no area. Where it crosses itself
/// the result has holes or covers parts twice. Cost: the square of the corners; 64 take 0.1 ms.
Mesh make_polygon(std::span<const Vec3> corners);

}  // namespace meristem
