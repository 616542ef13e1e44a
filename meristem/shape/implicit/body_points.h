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

/// Along one side of a grid, at most.
inline constexpr double kMostBodyCells = 1 << 29;

/// Where in a body to take points.
struct BodyGrid {
  DVec3 origin{0};                   ///< a corner of the grid's cells
  double spacing = 1;                ///< metres along a cell's side
  double depth = 1e9;                ///< metres below the surface down to which points lie
  std::uint64_t most = 0xffffffffU;  ///< points; one more than that is the last
};

struct BodyPoint {
  Vec3 position{0};
  Vec3 outward{0, 1, 0};  ///< unit, along the body's gradient
  glm::ivec3 cell{0};     ///< counted from the grid's origin
};

/// One point in each cell of a grid, anywhere in it by `key`, of those that lie in the body: as dense everywhere.
/// Whether a cell has one does not depend on what else there is. Cost by points and by the body's surface, not by the
/// size of its box. Throws Cancelled;
/// std::invalid_argument for more than kMostBodyCells along the body's box.
std::vector<BodyPoint> places_in(const ImplicitBody& body, const BodyGrid& grid, RandomKey key, Progress& progress);

}  // namespace meristem
