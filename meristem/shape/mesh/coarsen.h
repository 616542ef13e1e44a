// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "meristem/base/mesh.h"

namespace meristem {

/// Returns an organ's mesh with about `triangles` triangles, for distant views. Small pieces, such as a leaf's stalk,
/// are removed first. Then vertices are removed, and the remaining vertices keep their normals and uvs. If this is not
/// sufficient, an even choice of many pieces, such as needles, stays. They are widened, up to four times, so that the
/// total area stays. Each remaining piece has at least two triangles. It keeps more if its vertices cannot be removed:
/// seams, where several vertices share a position, collapse only along themselves. In this case, the mesh may lose
/// area. Flat shading stays. The result has no tangents. A mesh of more than 2000 triangles is returned unchanged. The
/// cost is about linear in the triangles: 20 µs for each.
Mesh coarsened(const Mesh& mesh, std::size_t triangles);

/// Like coarsened(), for a mesh of any size, at about 1 µs per triangle: all vertices in one cell of a grid become one.
/// The result is rougher, because seams close and outlines lose more. It has at least two triangles if the mesh is flat
/// enough to show them.
Mesh quickly_coarsened(const Mesh& mesh, std::size_t triangles);

}  // namespace meristem
