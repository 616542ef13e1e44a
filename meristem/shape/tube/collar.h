// SPDX-License-Identifier: Apache-2.0
// The collar with which a branch grows out of its parent. Below a first free ring, the branch's surface lines run
// straight back toward the parent and bend onto its bark in a fillet. Both surfaces and their normals therefore meet
// without a crease.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "meristem/shape/tube/axis_path.h"

namespace meristem {

/// The surface of a parent axis near one of its nodes, as cones between its nodes. The cones are stored in columns, so
/// that a processor handles several cones at once: a collar needs a hundred queries.
class Bark {
 public:
  struct Nearest {
    float distance = 0;     ///< metres from the bark, negative inside; exact for cylinders, slightly too large where
                            ///< the axis tapers
    Vec3 outward{0, 1, 0};  ///< away from the axis, of any length
    Vec3 normal() const { return unit_or(outward, Vec3(0, 1, 0)); }  ///< unit normal of the bark
  };

  /// `point` is an index in the parent's path. Parts farther than `reach` metres along the path are ignored.
  Bark(const AxisPath& parent, std::size_t point, float reach);

  Nearest nearest(Vec3 position) const;
  float distance(Vec3 position) const;
  float radius() const { return radius_; }  ///< radius of the parent at the node
  /// Returns where a ray that starts outside hits the bark, or comes nearest to it: metres along the unit `direction`,
  /// at most `farthest`.
  float trace(Vec3 from, Vec3 direction, float farthest) const;

 private:
  static constexpr std::size_t kMaxCones = 12;
  static constexpr float kNever = 1e30F;

  using Column = std::array<float, kMaxCones>;  // one value per cone
  using Columns = std::array<Column, 3>;

  void add(Vec3 base, Vec3 end, float base_radius, float end_radius);
  Vec3 axis(std::size_t k) const { return {axis_[0][k], axis_[1][k], axis_[2][k]}; }
  Vec3 offset(Vec3 position, std::size_t k) const { return position - Vec3(base_[0][k], base_[1][k], base_[2][k]); }
  /// Returns where along each cone's axis a position is nearest to the axis.
  Column shares(Vec3 position) const;
  /// Returns the distances from all cones, metres. Unused entries are kNever or more.
  Column distances(Vec3 position, const Column& shares) const;

  Columns base_{};
  Columns axis_{};  // from base to end
  Column inverse_length2_{};
  Column base_radius_;
  Column widening_{};  // growth of the radius to the end
  std::size_t count_ = 0;
  float radius_ = 0;
};

/// The place where a branch comes free of its parent.
struct Collar {
  Vec3 centre{0};           ///< centre of the first free ring
  Vec3 direction{0, 1, 0};  ///< direction of the branch at this ring
  float radius = 0;
  float fillet = 0;            ///< width of bark that the collar covers around the branch, metres
  std::size_t next_point = 0;  ///< first point of the branch's path after the ring
};

/// Returns the collar of the branch `path` on `bark`, with fillets of `size` times its radius if there is room. Returns
/// nothing if the branch leaves at too small an angle to the bark, or ends before it is free.
std::optional<Collar> plan_collar(const AxisPath& path, const Bark& bark, float size);

}  // namespace meristem
