// SPDX-License-Identifier: Apache-2.0
// The part of a plant that a mesh shows, so that each of its triangles can be traced back to a shoot or an organ.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "meristem/plant/plant.h"

namespace meristem {

/// Marks a missing number of a prototype or planting.
inline constexpr std::uint32_t kNoNumber = std::numeric_limits<std::uint32_t>::max();

/// The tube of an axis in a mesh: from this triangle to the first triangle of the next tube.
struct AxisTriangles {
  std::uint32_t first = 0;  ///< index of the first triangle of the tube
  AxisIndex axis = 0;       ///< axis of the stem's skeleton
};

/// The origin of a mesh. Exactly one of `stem`, `prototype` and `planting` is a number.
struct MeshOrigin {
  std::uint32_t stem = kNoStem;  ///< index into Plant::stems, whose surface the mesh is
  /// The tubes in the mesh, by ascending triangle. Null for bodies, whose triangles belong to several axes.
  std::shared_ptr<const std::vector<AxisTriangles>> tubes{};
  /// Index into Plant::prototypes. The frames of the mesh are the frames of the organs of this prototype, in their
  /// order.
  std::uint32_t prototype = kNoNumber;
  std::uint32_t planting = kNoNumber;         ///< index into Plant::plantings, whose variant has the mesh
  std::shared_ptr<const MeshOrigin> inner{};  ///< with a planting: the part of the variant's own plant that the mesh
                                              ///< shows
};

}  // namespace meristem
