// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/base/vec.h"
#include "meristem/shape/implicit/implicit_body.h"

namespace meristem {

/// Maximum number of cells along one side of a grid.
inline constexpr double kMaxBodyCells = 1 << 29;

/// The grid of points in a body.
struct BodyGrid {
  DVec3 origin{0};                  ///< a corner of the grid's cells
  double spacing = 1;               ///< length of a cell's side, metres
  double depth = 1e9;               ///< maximum depth of points below the surface, metres
  std::uint64_t max = 0xffffffffU;  ///< maximum number of points; the search stops after one more
};

struct BodyPoint {
  Vec3 position{0};
  Vec3 outward{0, 1, 0};  ///< unit vector along the body's gradient
  glm::ivec3 cell{0};     ///< counted from the grid's origin
};

/// Returns one random point in each cell of a grid, drawn by `key`, if the point lies in the body. The density is
/// therefore equal everywhere. The point of a cell does not depend on other cells. The cost depends on the points and
/// the body's surface, not on the size of its box. Throws Cancelled, and std::invalid_argument for more than
/// kMaxBodyCells along the body's box.
std::vector<BodyPoint> places_in(const ImplicitBody& body, const BodyGrid& grid, RandomKey key, Progress& progress);

}  // namespace meristem
