// SPDX-License-Identifier: Apache-2.0
// Tubes along the axes of a skeleton. Each node has a ring of vertices in the plane that bisects the bend (mitred).
// Rings are carried along without twist, joined by triangles, and closed at both ends. A lateral tube grows out of its
// parent with a collar (collar.h). Without a collar, it starts inside the parent with the radius of its own first node,
// or as much of it as fits inside. Where an axis ends and another continues in its direction with a similar radius,
// both tubes share one ring, and the texture continues. Steps in thickness are smoothed along the axis and roots flare,
// according to the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// The size of the result of make_tubes, known before memory is used.
struct TubeSize {
  std::uint64_t vertices = 0;   ///< vertices of the mesh
  std::uint64_t triangles = 0;  ///< triangles of the mesh

  /// Returns the heap bytes of the mesh.
  std::uint64_t bytes() const { return vertices * (2 * sizeof(Vec3) + sizeof(Vec2)) + triangles * 12; }
};

class TubePlan;

/// Returns the tubes of all axes as one mesh with normals and uvs: a closed body for each axis. Axes of a single node
/// without a parent have no tube.
///
/// Laterals have collars if they have at least 6 sides and are thicker than what the parent's flat sides hide. The
/// thickest tube has `surface.sides` sides (at least 3). The number falls with the cube root of an axis's first radius,
/// so that no tube deviates more from round than the thickest tube: radius * (1 - cos(pi / sides)). Nodes get no ring
/// where axis and radius are straight within `surface.error` radii. u goes around a whole number of times, so that
/// tiles are as near to `surface.uv_scale` metres as possible. v grows along the axis so that a tile keeps its aspect
/// where the tube tapers. On the outside of a bend, no vertex is farther than 1.27 radii from its axis. Where an axis
/// bends within its tube's own radius, the inner side is compressed, and rings do not cross.
///
/// The mesh is empty if `surface.style` is not `tubes`. Counts the skeleton's nodes in the caller's stage of
/// `progress`. Throws Cancelled. Throws std::invalid_argument if the mesh would need more than 2^32 vertices, or if
/// `surface.uv_scale` is not above 0. Deterministic on any number of threads. The cost is linear in nodes.
Mesh make_tubes(const Skeleton& skeleton, const SurfaceOptions& surface, Progress& progress);

/// Returns the tubes of a skeleton whose axes have different surfaces: the meshes of a plan (tube_plan.h).
std::vector<Mesh> make_tubes(const TubePlan& plan, Progress& progress);

}  // namespace meristem
