// SPDX-License-Identifier: Apache-2.0
// Closed primitives, standing on the origin's plane with y up: base centre (for sphere and torus: centre) at the
// origin. Normals follow the true surface, creases have split vertices, front faces outward.
#pragma once

#include "meristem/base/mesh.h"

namespace meristem {

/// A box of the given size (metres), x and z centred, y from 0 up.
Mesh make_box(Vec3 size);
/// A sphere about the origin. `segments` around (at least 3), half as many from pole to pole (at least 2).
Mesh make_sphere(double radius, int segments);
/// A cylinder from y = 0 to `height`, with both caps.
Mesh make_cylinder(double radius, double height, int segments);
/// A cone from y = 0 to its apex at `height`, with its base.
Mesh make_cone(double radius, double height, int segments);
/// A torus about the y axis: `radius` to the middle of a tube of `tube` radius; `segments` around, half as many (at
/// least 3) around the tube.
Mesh make_torus(double radius, double tube, int segments);

}  // namespace meristem
