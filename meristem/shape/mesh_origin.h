// SPDX-License-Identifier: Apache-2.0
// What of a plant a mesh shows, so that each of its triangles can be traced back to a shoot or an organ.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "meristem/plant/plant.h"

namespace meristem {

/// In place of the number of a prototype or planting.
inline constexpr std::uint32_t kNoNumber = std::numeric_limits<std::uint32_t>::max();

/// The tube of an axis in a mesh: from this triangle up to the first of the next tube.
struct AxisTriangles {
  std::uint32_t first = 0;  ///< index of the first triangle of the tube
  AxisIndex axis = 0;       ///< axis of the stem's skeleton
};

/// Exactly one of `stem`, `prototype` and `planting` is a number.
struct MeshOrigin {
  std::uint32_t stem = kNoStem;  ///< index into Plant::stems, whose surface the mesh is
  /// The tubes in the mesh, by rising triangle. Null for bodies, whose triangles belong to several axes.
  std::shared_ptr<const std::vector<AxisTriangles>> tubes{};
  /// Index into Plant::prototypes: the frames of the mesh are those of the organs of that prototype, in their order.
  std::uint32_t prototype = kNoNumber;
  std::uint32_t planting = kNoNumber;         ///< index into Plant::plantings, whose variant has the mesh
  std::shared_ptr<const MeshOrigin> inner{};  ///< what the mesh shows of the variant's own plant, with a planting
};

}  // namespace meristem
