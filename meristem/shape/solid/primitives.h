// SPDX-License-Identifier: Apache-2.0
// Closed primitives on the plane y = 0, with y up. The centre of the base is at the origin (for sphere and torus, the
// centre). Lengths are in metres. Normals follow the true surface, creases have split vertices, and front faces look
// outward. All functions throw std::invalid_argument for fewer than 3 segments, and for sizes that are not finite and
// above 0.
#pragma once

#include "meristem/base/mesh.h"

namespace meristem {

/// Returns a box of the given size (metres), with x and z centred and y from 0 up.
Mesh make_box(Vec3 size);
/// Returns a sphere about the origin with `segments` around it (at least 3), and half as many from pole to pole (at
/// least 2).
Mesh make_sphere(double radius, int segments);
/// Returns a cylinder from y = 0 to `height`, with both caps.
Mesh make_cylinder(double radius, double height, int segments);
/// Returns a cone from y = 0 to its apex at `height`, with its base.
Mesh make_cone(double radius, double height, int segments);
/// Returns a torus about the y axis. `radius` is the distance of the tube's middle from the axis, and `tube` the radius
/// of the tube. `segments` go around the axis, and half as many (at least 3) around the tube. Throws
/// std::invalid_argument if `tube` is not smaller than `radius`.
Mesh make_torus(double radius, double tube, int segments);

}  // namespace meristem
