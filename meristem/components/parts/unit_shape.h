// SPDX-License-Identifier: Apache-2.0
// Primitives that instances of any size share.
#pragma once

#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"

namespace meristem {

enum class UnitShape { box, sphere, cylinder, cone, torus };

/// Width of a torus's tube, as a share of the torus's width.
inline constexpr float kTorusTube = 0.25F;

/// Returns the shape with width 1 and `segments` corners around.
Mesh make_unit_shape(UnitShape shape, int segments);

/// Returns the number of triangles of make_unit_shape.
double unit_shape_triangles(UnitShape shape, int segments);

/// Returns the frame that places the unit shape on the origin with the width, height and depth of `size`.
Frame unit_shape_frame(UnitShape shape, Vec3 size);

}  // namespace meristem
