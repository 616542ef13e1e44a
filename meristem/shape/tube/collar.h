// SPDX-License-Identifier: Apache-2.0
// The collar with which a branch grows out of its parent: below a first free ring its surface lines run straight back
// toward the parent and bend over onto its bark in a fillet, so that both surfaces and their normals meet without a
// crease.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "meristem/shape/tube/axis_path.h"

namespace meristem {

/// The surface of a parent axis near one of its nodes, as cones between its nodes.
class Bark {
 public:
  /// `point` counts along the parent's path; what is farther than `reach` metres along it plays no part.
  Bark(const AxisPath& parent, std::size_t point, float reach);

  /// Metres from the bark, negative inside; exact for cylinders, a little too much where it tapers.
  float distance(Vec3 position) const;
  /// The bark's outward unit normal nearest to a position.
  Vec3 normal(Vec3 position) const;
  float radius() const { return radius_; }  ///< of the parent at the node
  /// Where a ray that starts outside meets the bark, or comes nearest to it: metres along the unit `direction`, at most
  /// `farthest`.
  float trace(Vec3 from, Vec3 direction, float farthest) const;

 private:
  struct Cone {
    Vec3 base{0};
    Vec3 axis{0};  // from base to end
    float inverse_length2 = 0;
    float base_radius = 0;
    float widening = 0;  // to the end's radius
  };
  struct Nearest {
    float distance;
    Vec3 outward;
  };
  Nearest nearest(Vec3 position) const;

  static constexpr std::size_t kMostCones = 12;
  std::array<Cone, kMostCones> cones_;
  std::size_t count_ = 0;
  float radius_ = 0;
};

/// Where a branch comes free of its parent.
struct Collar {
  Vec3 centre{0};           ///< of the first free ring
  Vec3 direction{0, 1, 0};  ///< of the branch there
  float radius = 0;
  float fillet = 0;            ///< metres of bark that the collar reaches over beyond the branch
  std::size_t next_point = 0;  ///< of the branch's path, the first after the ring
};

/// The collar of the branch `path` on `bark`, with fillets of `size` times its radius where there is room. Nothing
/// where the branch leaves too steeply along the bark, or ends before it is free.
std::optional<Collar> plan_collar(const AxisPath& path, const Bark& bark, float size);

}  // namespace meristem
