// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "meristem/base/mesh.h"

namespace meristem {

struct MeshPromises {
  bool closed = true;   ///< every edge has two triangles; false for blades
  bool outward = true;  ///< the signed volume is positive; only for closed meshes
};

/// Success if arrays have fitting lengths, all numbers are finite, indices in range, no triangle is degenerate, no edge
/// has more than two triangles, neighbours agree in orientation, normals are unit and lie on their triangles' front
/// sides, and what `promises` says. Vertices at the same place count as one for edges (uv seams, creases). The failure
/// names the triangle and its vertices.
testing::AssertionResult check_mesh(const Mesh& mesh, MeshPromises promises = {});

/// Six times the signed volume summed over triangles, divided by six; positive for closed outward meshes.
double signed_volume(const Mesh& mesh);
double surface_area(const Mesh& mesh);

/// Vertices minus edges plus triangles, vertices at the same place counted once: 2 for a sphere, 0 for a torus.
long euler_number(const Mesh& mesh);

}  // namespace meristem
