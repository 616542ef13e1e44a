// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "meristem/base/mesh.h"

namespace meristem {

struct MeshPromises {
  bool closed = true;   ///< every edge has two triangles; false for blades
  bool outward = true;  ///< the signed volume is positive; only for closed meshes
};

/// Succeeds if the mesh is valid and fulfils `promises`. Arrays must have matching lengths, numbers must be finite, and
/// indices must be in range. No triangle may be degenerate, no edge may have more than two triangles, and neighbours
/// must agree in orientation. Normals must be unit vectors on the front sides of their triangles. Vertices at equal
/// positions count as one for edges (uv seams, creases). The failure names the triangle and its vertices.
testing::AssertionResult check_mesh(const Mesh& mesh, MeshPromises promises = {});

/// Returns the signed volume: positive for closed meshes that face outward.
double signed_volume(const Mesh& mesh);
double surface_area(const Mesh& mesh);

/// Returns vertices minus edges plus triangles: 2 for a sphere, 0 for a torus. Vertices at equal positions count once.
long euler_number(const Mesh& mesh);

}  // namespace meristem
