// SPDX-License-Identifier: Apache-2.0
// Tubes along the axes of a skeleton: one ring of vertices a node, in the plane that halves the bend (mitred), carried
// along without twist, joined by triangles, closed at the tip. A lateral tube starts inside its mother with its own first
// node's radius.
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, section 3.6.1 (equation 3.26 holds for the interior angle); ring frames by double reflection, W. Wang et al.:
// Computation of rotation minimizing frames (2008).
#pragma once

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// The tubes of all axes as one mesh with normals and uvs. u goes once around for every whole number of tiles, v along
/// the axis in tiles of `surface.uv_scale` metres, so that bark neither stretches nor seams.
/// Deterministic on any number of threads; cost linear in nodes.
Mesh make_tubes(const Skeleton& skeleton, const Surface& surface, Progress& progress);

}  // namespace meristem
