// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/scene/obstacle/closed_mesh.h"

namespace meristem {

/// Finds the triangles of many bodies on a ray. Embree's tree says which ones to ask, and each is asked in double
/// precision, so that answers depend neither on the tree nor on the machine's instructions.
class ObstacleTree {
 public:
  struct Hit {
    double distance = 0;   ///< in lengths of the ray's direction
    std::size_t body = 0;  ///< the lowest of those met there
  };

  /// A position on a triangle.
  struct Near {
    DVec3 position{0};
    DVec3 normal{0};  ///< unit vector out of the triangle's front; 0 where it has no area
  };

  /// Bodies with finite positions and indices in range, which need not outlive this. Throws MachineError.
  explicit ObstacleTree(const std::vector<const TriangleMesh*>& bodies);
  ~ObstacleTree();
  ObstacleTree(const ObstacleTree&) = delete;
  ObstacleTree& operator=(const ObstacleTree&) = delete;

  /// The first triangle on a ray, at most `within` lengths of its direction away; nothing for what is not finite.
  std::optional<Hit> first_hit(DVec3 origin, DVec3 direction, double within) const;
  /// Whether there is any.
  bool is_met(DVec3 origin, DVec3 direction, double within) const;
  /// The nearest position on any triangle; of equally near ones that of the first in the bodies' order. Nothing where
  /// there are no triangles, or for a position that is not finite.
  std::optional<Near> nearest(DVec3 position) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace meristem
