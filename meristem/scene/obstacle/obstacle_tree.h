// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/scene/obstacle/closed_mesh.h"

namespace meristem {

/// Finds the triangles of many bodies on a ray. Embree's tree proposes candidates, and each candidate is tested in
/// double precision. The results therefore depend neither on the tree nor on the machine's instructions.
class ObstacleTree {
 public:
  struct Hit {
    double distance = 0;   ///< in lengths of the ray's direction
    std::size_t body = 0;  ///< the lowest index among the bodies at that distance
  };

  /// A position on a triangle.
  struct Near {
    DVec3 position{0};
    DVec3 normal{0};  ///< unit vector out of the triangle's front; 0 if it has no area
  };

  /// The bodies must have finite positions and valid indices. They need not outlive this object. Throws MachineError.
  explicit ObstacleTree(const std::vector<const TriangleMesh*>& bodies);
  ~ObstacleTree();
  ObstacleTree(const ObstacleTree&) = delete;
  ObstacleTree& operator=(const ObstacleTree&) = delete;

  /// Returns the first triangle on a ray, at most `within` lengths of `direction` away. Returns nothing for values that
  /// are not finite.
  std::optional<Hit> first_hit(DVec3 origin, DVec3 direction, double within) const;
  /// Returns true if there is any such triangle.
  bool is_met(DVec3 origin, DVec3 direction, double within) const;
  /// Returns the nearest position on any triangle (tie: the first triangle in the bodies' order). Returns nothing if
  /// there are no triangles or if the position is not finite.
  std::optional<Near> nearest(DVec3 position) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace meristem
