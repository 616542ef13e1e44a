// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "meristem/base/mesh.h"

namespace meristem {

/// An organ's mesh with about this number of `triangles`, for a look from afar. Small pieces, such as a leaf's stalk,
/// go; then vertices go, and those that stay keep their normals and uvs. Where that does not suffice, of many pieces,
/// such as needles, an even choice stays; these are wider, up to four times, so that their area in all stays. Fewer
/// pieces have two triangles each at least, or more where vertices cannot go: seams, where several share a position, go
/// along themselves only. They may lose area. What is shaded flat stays so. No tangents.
/// Returns a mesh of more than 2000 triangles unchanged. The cost is about linear in the triangles: 20 µs for each.
Mesh coarsened(const Mesh& mesh, std::size_t triangles);

/// Like coarsened(), for a mesh of any size, at about 1 µs for each triangle: all vertices in one cell of a grid become
/// one. Rougher: seams close and outlines lose more. Has at least two triangles if the mesh is flat enough to show
/// them.
Mesh quickly_coarsened(const Mesh& mesh, std::size_t triangles);

}  // namespace meristem
