// SPDX-License-Identifier: Apache-2.0
// Closed polygons in space, seen against their area.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "meristem/base/vec.h"

namespace meristem {

/// The diagonal of the box around the points.
double extent_of(std::span<const Vec3> points);

/// Twice the area of the polygon as a vector along its normal (M. Newell): from where it points to, the corners run
/// counter-clockwise. All edges of a crooked polygon have their share in it.
DVec3 area_vector(std::span<const Vec3> corners);

/// The corners seen against the vector `area`, stretched to the unit square.
std::vector<glm::dvec2> flattened(std::span<const Vec3> corners, DVec3 area);

/// A polygon's face in triangles of corners by their numbers; the number after the last is a point in their middle.
struct RingFace {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool has_middle = false;  ///< else they use no other points than the corners
};

/// The face of a polygon that is flattened, counter-clockwise and does not cross itself. Linear where all corners are
/// seen from their middle.
RingFace ring_face(const std::vector<glm::dvec2>& corners);

}  // namespace meristem
