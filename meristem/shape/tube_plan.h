// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meristem/plant/plant.h"
#include "meristem/shape/axis_path.h"
#include "meristem/shape/collar.h"
#include "meristem/shape/tubes.h"

namespace meristem {

/// What one axis becomes, and where it stands in the mesh.
struct AxisPlan {
  static constexpr std::uint32_t kCollarRings = 5;  ///< hidden, on the bark, two in the fillet, free
  static constexpr std::uint32_t kFlareRings = 3;   ///< between a root's first two nodes

  std::uint32_t sides = 0;
  std::uint32_t rings = 0;
  std::uint32_t flare_rings = 0;
  float start_radius = 0;
  float sink = 0;  ///< metres by which the mother's flats may lie below her bark
  std::optional<Collar> collar;
  std::uint64_t first_vertex = 0;
  std::uint64_t first_triangle = 0;

  // A lateral's start is one hidden point; a root's is a flat disc with vertices of its own. A tip has a point a side.
  std::uint64_t start_vertices(bool is_lateral) const { return is_lateral ? 1 : sides + 1; }
  std::uint64_t vertices(bool is_lateral) const {
    return rings == 0 ? 0 : std::uint64_t{rings} * (sides + 1) + start_vertices(is_lateral) + sides;
  }
  std::uint64_t triangles() const { return rings == 0 ? 0 : 2 * std::uint64_t{sides} * rings; }
};

/// How many rings share a bend with this cosine.
std::uint32_t fan_size(float cosine);

/// How much thicker a root is at so many metres from its base.
float flare_factor(const Surface& surface, float base_radius, float metres);

/// All axes of a skeleton with their places in the mesh.
class TubePlan {
 public:
  /// Both outlive the plan.
  TubePlan(const Skeleton& skeleton, const Surface& surface);

  TubeSize size() const { return size_; }
  std::size_t axis_count() const { return plans_.size(); }
  int most_sides() const { return most_sides_; }
  const AxisPlan& operator[](std::size_t axis) const { return plans_[axis]; }
  AxisPath path(AxisIndex axis) const;
  /// The mother's surface about a lateral axis's start.
  Bark bark_below(const AxisPath& lateral) const;

 private:
  void smooth_radii(AxisIndex axis);
  void choose_sides(AxisIndex axis);
  void count_rings(AxisIndex axis);
  void plan_start(const AxisPath& points, AxisPlan& plan) const;
  float room_inside(NodeIndex node) const;

  const Skeleton& skeleton_;
  const Surface& surface_;
  Axes axes_;
  int most_sides_ = 3;
  float thickest_ = 0;
  std::vector<float> radii_;  // by node
  std::vector<AxisPlan> plans_;
  TubeSize size_;
};

}  // namespace meristem
