// SPDX-License-Identifier: Apache-2.0
// Meshes with fewer triangles: real low poly.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"

namespace meristem {

/// The target of a simplification, which stops at the limit that is reached first.
struct SimplifyTarget {
  std::size_t triangles = 0;  ///< the mesh is simplified to this number or one fewer; more triangles keep more of the
                              ///< form
  /// Approximate tolerance in metres: three times the root mean square distance of a vertex from the planes of the
  /// original triangles that it represents. On spheres, no part deviates by more. Larger values give fewer triangles.
  float error = std::numeric_limits<float>::infinity();
};

/// Returns the mesh with as few triangles as `target` requests, in about the same form. Vertices move, and thin parts
/// become prisms of three sides before they lose more.
///
/// A closed, manifold mesh whose triangles share their vertices stays closed, manifold and oriented, with equal Euler
/// number and as many components. No triangle turns over or becomes degenerate, and no two neighbours fold onto each
/// other. If no further step is possible, the result has more triangles than `target`, with at least four per
/// component. Vertices and edges on borders (seams of normals or uvs are borders) and on edges of more than two
/// triangles do not move. Surfaces may cross others that are near.
///
/// A mesh with no more triangles than `target.triangles` is returned unchanged. Otherwise, existing normals are
/// replaced by the normals of smooth_shaded(), and vertices without triangles are removed. The bytes are equal on every
/// machine. Runs on one thread, about linear, with 1.3 µs and 90 bytes per triangle.
///
/// Begins no stage, but advances the caller's stage by about the number of removed triangles. Stops within 50 ms.
/// Throws Cancelled. Throws std::invalid_argument for uvs or tangents, which moved vertices would invalidate, for
/// indices out of range, positions that are not finite, and an error that is negative or NaN.
Mesh simplify(const Mesh& mesh, const SimplifyTarget& target, Progress& progress);

/// Returns levels of detail: one mesh for each count of `triangles`, which must not rise, each simplified from the one
/// before. Takes about as long as the last one alone. Otherwise like simplify().
std::vector<Mesh> levels_of_detail(const Mesh& mesh, std::span<const std::size_t> triangles, Progress& progress);

}  // namespace meristem
