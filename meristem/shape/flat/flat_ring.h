// SPDX-License-Identifier: Apache-2.0
// Closed polygons in space, projected along their area vector.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "meristem/base/vec.h"

namespace meristem {

/// Returns the diagonal of the box around the points.
double extent_of(std::span<const Vec3> points);

/// Returns twice the area of the polygon as a vector along its normal (M. Newell). Seen from its tip, the corners run
/// counter-clockwise. For a polygon that is not flat, all edges contribute.
DVec3 area_vector(std::span<const Vec3> corners);

/// Returns the corners projected along the vector `area`, stretched to the unit square.
std::vector<glm::dvec2> flattened(std::span<const Vec3> corners, DVec3 area);

/// The face of a polygon as triangles of corner numbers. The number after the last corner is a point in the middle.
struct RingFace {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool has_middle = false;  ///< if false, the triangles use only the corners
};

/// Returns the face of a flattened polygon that runs counter-clockwise and does not cross itself. Linear if all corners
/// are visible from their middle.
RingFace ring_face(const std::vector<glm::dvec2>& corners);

}  // namespace meristem
