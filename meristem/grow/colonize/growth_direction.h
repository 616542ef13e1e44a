// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meristem/grow/colonize/nearest_nodes.h"

namespace meristem {

/// What the points of one node pull it toward.
struct Pull {
  NodeIndex node = 0;
  DVec3 sum{0};  ///< of the unit vectors from the node to its points
};

/// Sums up the unit vectors to the points of every node that has some.
///
/// Sums are of whole numbers (unit vectors in steps of 2^-38), so they do not depend on the order of the points.
class PullSums {
 public:
  /// All nodes with points, by rising index. Valid until the next call.
  std::span<const Pull> gather(const NearestNodes& nearest, std::span<const Vec3> node_positions);

 private:
  struct Sum {
    NodeIndex node;
    std::int64_t x, y, z;
  };

  std::vector<std::uint32_t> slot_;  // by node: its place in sums_ plus one; 0 between calls
  std::vector<Sum> sums_;
  std::vector<Pull> pulls_;
};

/// The unit vector of the sum's unit vector plus `bias`; nothing where one of them vanishes, as between two opposite
/// points.
std::optional<DVec3> growth_direction(const Pull& pull, DVec3 bias);

}  // namespace meristem
