// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "meristem/base/mesh.h"

namespace meristem {

/// An organ's mesh with about this number of `triangles`, for a look from afar. Small pieces, such as a leaf's stalk,
/// go; then vertices go, and those that stay keep their normals and uvs. Where that does not suffice, of many pieces,
/// such as needles, an even choice stays; these are wider, up to four times, so that their area in all stays. Fewer
/// pieces have two triangles each at least, or more where vertices cannot go: seams, where several share a position, go
/// along themselves only. They may lose area. What is shaded flat stays so. Cost grows with the square of the
/// triangles: meshes of over 2000 come back as they are. No tangents.
Mesh coarsened(const Mesh& mesh, std::size_t triangles);

}  // namespace meristem
