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

/// The surface of a parent axis near one of its nodes, as cones between its nodes. Their numbers stand side by side, so
/// that a processor looks at several cones at once: a collar asks a hundred times.
class Bark {
 public:
  struct Nearest {
    float distance = 0;     ///< metres from the bark, negative inside; exact for cylinders, a little too much where it
                            ///< tapers
    Vec3 outward{0, 1, 0};  ///< from the axis, of any length
    Vec3 normal() const { return unit_or(outward, Vec3(0, 1, 0)); }  ///< the bark's, unit
  };

  /// `point` counts along the parent's path; what is farther than `reach` metres along it plays no part.
  Bark(const AxisPath& parent, std::size_t point, float reach);

  Nearest nearest(Vec3 position) const;
  float distance(Vec3 position) const;
  float radius() const { return radius_; }  ///< of the parent at the node
  /// Where a ray that starts outside meets the bark, or comes nearest to it: metres along the unit `direction`, at most
  /// `farthest`.
  float trace(Vec3 from, Vec3 direction, float farthest) const;

 private:
  static constexpr std::size_t kMostCones = 12;
  static constexpr float kNever = 1e30F;

  using Column = std::array<float, kMostCones>;  // by cone
  using Columns = std::array<Column, 3>;

  void add(Vec3 base, Vec3 end, float base_radius, float end_radius);
  Vec3 axis(std::size_t k) const { return {axis_[0][k], axis_[1][k], axis_[2][k]}; }
  Vec3 offset(Vec3 position, std::size_t k) const { return position - Vec3(base_[0][k], base_[1][k], base_[2][k]); }
  /// Along each cone's axis where a position is nearest to it.
  Column shares(Vec3 position) const;
  /// Metres from all cones, kNever or more where there is none.
  Column distances(Vec3 position, const Column& shares) const;

  Columns base_{};
  Columns axis_{};  // from base to end
  Column inverse_length2_{};
  Column base_radius_;
  Column widening_{};  // to the end's radius
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
