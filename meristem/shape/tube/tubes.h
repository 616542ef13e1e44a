// SPDX-License-Identifier: Apache-2.0
// Tubes along the axes of a skeleton: one ring of vertices a node, in the plane that halves the bend (mitred), carried
// along without twist, joined by triangles, closed at both ends. A lateral tube grows out of its parent with a collar
// (collar.h); where that is not wanted or has no room it starts inside it with its own first node's radius, or as much
// of it as that can hide. Where an axis ends and another goes on in its direction, nearly as thick, both tubes have one
// ring, and the texture runs on. Steps in thickness are levelled along the axis and roots flare, as the surface says.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// What make_tubes will make, known before memory is spent.
struct TubeSize {
  std::uint64_t vertices = 0;   ///< vertices of the mesh
  std::uint64_t triangles = 0;  ///< triangles of the mesh

  /// Heap bytes of the mesh.
  std::uint64_t bytes() const { return vertices * (2 * sizeof(Vec3) + sizeof(Vec2)) + triangles * 12; }
};

class TubePlan;

/// The tubes of all axes as one mesh with normals and uvs: a closed body for each axis. Axes of a single node without a
/// parent make nothing.
///
/// Laterals have collars where they have at least 6 sides and more thickness than the parent's hides.
/// The thickest tube has `surface.sides` sides (at least 3); the number falls with the cube root of an axis's first
/// radius, so that nothing deviates more from round than the thickest tube: radius * (1 - cos(pi / sides)). Along an
/// axis nodes get no ring where axis and radius run straight within `surface.error` radii.
/// u goes around a whole number of times, as near to tiles of `surface.uv_scale` metres as can be; v grows along the
/// axis so that a tile keeps its aspect however the tube tapers.
/// No vertex is farther than 1.27 radii from its axis on the outside of a bend. Where an axis bends within its tube's
/// own radius, the inner side is pressed together, without rings that cross.
///
/// Counts the skeleton's nodes into the caller's stage of `progress`. Throws std::invalid_argument where the mesh would
/// need more than 2^32 vertices, Cancelled. Deterministic on any number of threads; cost linear in nodes.
Mesh make_tubes(const Skeleton& skeleton, const Surface& surface, Progress& progress);

/// The tubes of a skeleton whose axes wear different surfaces: the meshes of a plan (tube_plan.h).
std::vector<Mesh> make_tubes(const TubePlan& plan, Progress& progress);

}  // namespace meristem
