// SPDX-License-Identifier: Apache-2.0
// The bodies that stand in a scene: buildings, walls, rocks. They answer what growth asks: is this position inside one,
// does this segment pass through one, what does this ray meet. Exact or in double precision and the same on every
// machine, so that growth is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/scene/obstacle/closed_mesh.h"

namespace meristem {

/// One body, in world space.
struct Obstacle {
  TriangleMesh mesh;                 ///< metres; counter-clockwise seen from outside where it is closed
  Vec3 colour{0.76F, 0.73F, 0.68F};  ///< sRGB, in pictures
  bool is_broken = false;            ///< not closed, yet to be used as well as can be
  bool is_hidden = false;            ///< left out of pictures
  std::string name{};                ///< how measures find it; may be empty
};

/// The twelve triangles of a box, facing outward; `low` lies below `high` along each axis.
TriangleMesh box_mesh(DVec3 low, DVec3 high);

/// All obstacles of a scene. Copies share what is in them; queries may come from many threads at once.
class Obstacles {
 public:
  struct Hit {
    double distance = 0;       ///< metres along the ray
    std::size_t obstacle = 0;  ///< index into bodies()
  };

  Obstacles();
  /// Throws std::invalid_argument for indices out of range or positions that are not finite in 32 bits, and
  /// MachineError. Takes about 300 bytes and a microsecond per triangle.
  explicit Obstacles(std::vector<Obstacle> bodies);

  bool empty() const { return bodies().empty(); }
  const std::vector<Obstacle>& bodies() const;
  Box bounds() const;  ///< box around all obstacles; empty where there are none

  /// Whether a position is inside an obstacle. For a broken mesh the majority of three views decides, along x, y and z.
  bool contain(Vec3 position) const;
  /// Whether the way from one position to another meets a surface, be it only at an end or an edge. However short, a
  /// way from outside to inside does; one without length does not.
  bool cross(Vec3 from, Vec3 to) const;
  /// The first surface on a ray, at most `within` metres away, which may be infinite; `direction` is a unit vector.
  /// What only touches an edge is met. At equal distances the obstacle with the lower index.
  std::optional<Hit> first_hit(Vec3 origin, Vec3 direction, double within) const;
  /// Whether there is any, which costs less.
  bool block(Vec3 origin, Vec3 direction, double within) const;
  /// The way from the nearest surface to a position, a unit vector: out of that surface where the position lies on it,
  /// and toward the surface where it is inside a body. Nothing where there are no obstacles.
  std::optional<Vec3> away_from_surface(Vec3 position) const;
  /// Metres from a position to the nearest surface; infinite where there are no obstacles.
  double distance_to_surface(Vec3 position) const;
  /// The centroid of an obstacle's volume, of a broken one's surface, put down on the ground (y = 0).
  Vec3 ground_centroid(std::size_t obstacle) const;

 private:
  struct Content;
  std::shared_ptr<const Content> content_;
};

/// For each of `positions` whether it is inside an obstacle: 1 or 0. On all threads; throws Cancelled.
std::vector<std::uint8_t> inside_of(const Obstacles& obstacles, std::span<const Vec3> places, const Progress& progress);

}  // namespace meristem
