// SPDX-License-Identifier: Apache-2.0
// The skeletons of a plant as cylinders, in the form of programs that reconstruct trees from scans.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Marks a missing cylinder.
inline constexpr std::uint32_t kNoCylinder = 0xffffffffU;

/// The segment that ends in a node. Metres, in the coordinates of such programs: x east, y north, z up.
struct TreeCylinder {
  Vec3 begin{0};                          ///< metres
  Vec3 end{0};                            ///< metres
  float radius = 0;                       ///< radius with which the cylinder has the volume of the cone between its two
                                          ///< nodes
  std::uint32_t parent = kNoCylinder;     ///< the cylinder on which it begins; kNoCylinder at a root
  std::uint32_t extension = kNoCylinder;  ///< the next cylinder of its axis
  std::uint32_t axis = 0;                 ///< number of its axis, as in SkeletonTable
  std::uint32_t position = 0;             ///< number of the cylinder on its axis, from 0
  std::uint16_t order = 0;                ///< branching order of its axis
};

/// Returns the radius of a cylinder that has the volume of a cone of equal length.
float radius_of_equal_volume(float begin, float end);

/// Returns the radius of the cylinder that ends in a node. Along an axis, the cylinder has the volume of the cone. The
/// first cylinder of a lateral axis has the radius of the axis's first node.
float cylinder_radius(const Skeleton& skeleton, NodeIndex node);

/// Returns a cylinder for each node that has a parent, in the order of SkeletonTable.
std::vector<TreeCylinder> cylinders_of(const Plant& plant);

}  // namespace meristem
