// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meristem/plant/plant.h"
#include "meristem/shape/tube/axis_path.h"
#include "meristem/shape/tube/collar.h"
#include "meristem/shape/tube/tubes.h"

namespace meristem {

/// The planned tube of one axis, and its position in the mesh.
struct AxisPlan {
  static constexpr std::uint32_t kCollarRings = 5;  ///< hidden, on the bark, two in the fillet, free
  static constexpr std::uint32_t kFlareRings = 3;   ///< between a root's first two nodes
  static constexpr std::uint32_t kDomeRings = 2;    ///< of a round cap, beyond the last node

  std::uint32_t sides = 0;
  std::uint32_t rings = 0;
  std::uint32_t flare_rings = 0;
  float start_radius = 0;
  float sink = 0;  ///< metres: maximum depth of the parent's flat sides below its bark
  std::optional<Collar> collar;
  AxisIndex successor = kNoAxis;  ///< the axis whose tube continues this one, beginning with its last ring
  bool succeeds = false;          ///< true if this tube continues another one
  SurfaceOptions::Cap cap = SurfaceOptions::Cap::pointed;  ///< flat if the axis was cut off
  std::uint32_t mesh = 0;                                  ///< index of its mesh
  std::uint64_t first_vertex = 0;                          ///< index in that mesh
  std::uint64_t first_triangle = 0;

  // Returns the number of vertices of the start. A lateral's start is one hidden point, and a root's start is a flat
  // disc with separate vertices. A pointed tip has a point per side, and a flat one has a disc.
  std::uint64_t start_vertices(bool is_lateral) const { return is_lateral ? 1 : sides + 1; }
  std::uint64_t vertices(bool is_lateral) const {
    const std::uint64_t end = cap == SurfaceOptions::Cap::flat ? sides + 1 : sides;
    return rings == 0 ? 0 : std::uint64_t{rings} * (sides + 1) + start_vertices(is_lateral) + end;
  }
  std::uint64_t triangles() const { return rings == 0 ? 0 : 2 * std::uint64_t{sides} * rings; }
};

/// Returns how many rings share a bend with this cosine.
std::uint32_t fan_size(float cosine);

/// Returns the factor on a root's radius at this distance in metres from its base.
float flare_factor(const SurfaceOptions& surface, float base_radius, float metres);

/// The surface and the mesh of the tubes of some axes.
struct TubeWear {
  SurfaceOptions surface;
  std::uint32_t mesh = 0;
  bool left_out = false;         ///< if true, these axes get no tubes, and everything on them is left out as well
  std::size_t longest_run = 12;  ///< maximum number of nodes per ring; the cost of an axis grows with it
};

/// All axes of a skeleton with their positions in meshes.
class TubePlan {
 public:
  /// `wear_of_axis` has an index into `wears` for each axis. Empty: all axes use the first. `mesh_of_axis` has the mesh
  /// of each axis. Empty: the mesh of its wear. If the mesh will be deformed, `deformed` has the deformed positions of
  /// the nodes: nodes at bends of the deformed axis keep their rings. Skeleton and positions must outlive the plan.
  TubePlan(const Skeleton& skeleton, std::vector<TubeWear> wears, std::vector<std::uint32_t> wear_of_axis = {},
           const std::vector<std::uint32_t>& mesh_of_axis = {}, std::span<const Vec3> deformed = {});

  /// Returns the size of each mesh.
  const std::vector<TubeSize>& sizes() const { return sizes_; }
  std::size_t axis_count() const { return plans_.size(); }
  int max_sides() const { return max_sides_; }
  const AxisPlan& operator[](std::size_t axis) const { return plans_[axis]; }
  const SurfaceOptions& surface(std::size_t axis) const { return wears_[wear(axis)].surface; }
  std::size_t node_count(AxisIndex axis) const { return axes_.of(axis).size(); }
  /// Returns the path of an axis through the nodes that get rings.
  AxisPath path(AxisIndex axis) const;
  /// Returns the parent's surface around a lateral axis's start.
  Bark bark_below(const AxisPath& lateral) const;

 private:
  std::size_t wear(std::size_t axis) const { return wear_of_axis_.empty() ? 0 : wear_of_axis_[axis]; }
  /// Returns the maximum depth of the flat sides of an axis's tube below its bark.
  float roundness(std::size_t axis) const;
  void find_start(AxisIndex axis);
  float base_radius(AxisIndex axis, bool goes_on) const;
  bool find_whether_it_goes_on(AxisIndex axis) const;
  void find_successors();
  void smooth_radii(AxisIndex axis);
  void choose_rings(AxisIndex axis);
  bool is_straight(std::span<const Vec3> positions, std::span<const NodeIndex> nodes, std::size_t from, std::size_t to,
                   float error) const;
  void choose_sides(AxisIndex axis);
  void count_rings(AxisIndex axis);
  SurfaceOptions::Cap cap(AxisIndex axis) const;
  void plan_start(const AxisPath& points, AxisPlan& plan, AxisIndex axis) const;
  float room_inside(NodeIndex node) const;

  const Skeleton* skeleton_;
  std::span<const Vec3> deformed_;
  std::vector<TubeWear> wears_;
  std::vector<std::uint32_t> wear_of_axis_;
  SkeletonAxes axes_;
  std::vector<NodeIndex> kept_;            // nodes of the axes that get rings, for each axis at the positions of its
                                           // nodes in axes_
  std::vector<std::uint32_t> kept_count_;  // for each axis
  std::vector<std::uint8_t> is_tip_;       // for each node, whether it is the last of its axis
  // Facts of each axis, found once, because both need the parent, which can be anywhere in memory.
  std::vector<std::uint8_t> goes_on_;
  std::vector<float> base_radius_;
  int max_sides_ = 3;
  std::vector<float> thickest_;  // for each wear
  std::vector<float> radii_;     // indexed by node
  std::vector<AxisPlan> plans_;
  std::vector<TubeSize> sizes_;
};

}  // namespace meristem
