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

/// When to stop: at whichever comes first.
struct SimplifyTarget {
  std::size_t triangles = 0;  ///< simplified to this number or one fewer; more keep more of the form
  /// Tolerance in metres, about: three times the root mean square distance that a vertex has from
  /// the planes of those triangles of the original that it stands for; on spheres nothing departs by more. Higher:
  /// fewer triangles.
  float error = std::numeric_limits<float>::infinity();
};

/// The mesh with as few triangles as `target` asks for, in about the same form: vertices move, and thin parts become
/// prisms of three sides before they lose more.
///
/// A closed, manifold mesh whose triangles share their vertices stays closed, manifold and oriented, with the same
/// Euler number and as many components; no triangle turns over or becomes degenerate, no two neighbours fold onto each
/// other. If no further step is possible, more triangles are left than `target`: at least four of each component.
/// Vertices on borders (seams of normals or uvs are borders) and on edges of more than two triangles stay where they
/// are, as do the edges between them. Surfaces may come to cross others that are near.
///
/// A mesh with no more triangles than `target.triangles` comes back as it is. Else normals, if there are any, are those
/// of smooth_shaded(); vertices without triangles go. The bytes are equal on every machine; one thread; about linear,
/// with 1.3 µs and 90 bytes per triangle.
///
/// Begins no stage; counts about as many triangles as it takes away into the caller's; stops within 50 ms. Throws
/// Cancelled; std::invalid_argument for uvs or tangents, which moved vertices would need anew, for indices out of
/// range, positions that are not finite, an error that is negative or NaN.
Mesh simplify(const Mesh& mesh, const SimplifyTarget& target, Progress& progress);

/// Levels of detail: one mesh for each count of `triangles`, which must not rise, each simplified from the one before;
/// together about as long as the last alone. Else as simplify().
std::vector<Mesh> levels_of_detail(const Mesh& mesh, std::span<const std::size_t> triangles, Progress& progress);

}  // namespace meristem
