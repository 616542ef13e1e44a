// SPDX-License-Identifier: Apache-2.0
// The bodies in a scene: buildings, walls, rocks. Growth asks whether a position is inside a body, whether a segment
// passes through one, and what a ray meets. Results are exact or in double precision, and equal on every machine.
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
  TriangleMesh mesh;                 ///< metres; counter-clockwise seen from outside if it is closed
  Vec3 colour{0.76F, 0.73F, 0.68F};  ///< sRGB, in pictures
  bool is_broken = false;            ///< the mesh is not closed, but is used as well as possible
  bool is_hidden = false;            ///< not drawn in pictures
  std::string name{};                ///< name for measures; may be empty
};

/// Returns the twelve triangles of a box, facing outward; `low` is below `high` along each axis.
TriangleMesh box_mesh(DVec3 low, DVec3 high);

/// All obstacles of a scene. Copies share their content. Queries are thread-safe.
class Obstacles {
 public:
  /// A surface that a ray meets.
  struct Hit {
    double distance = 0;       ///< metres along the ray
    std::size_t obstacle = 0;  ///< index into bodies()
  };

  Obstacles();
  /// Throws std::invalid_argument for invalid indices or for positions that are not finite in 32 bits. Throws
  /// MachineError. Takes about 300 bytes and one microsecond per triangle.
  explicit Obstacles(std::vector<Obstacle> bodies);

  bool empty() const { return bodies().empty(); }  ///< true if there are no obstacles
  const std::vector<Obstacle>& bodies() const;     ///< in the order in which they were given
  Box bounds() const;                              ///< box around all obstacles; empty without obstacles

  /// Returns true if a position is inside an obstacle. For a broken mesh, the majority of three views along x, y and z
  /// decides.
  bool contain(Vec3 position) const;
  /// Returns true if the way from one position to another meets a surface, even only at an end or an edge. A way from
  /// outside to inside always does, however short. A way of zero length does not.
  bool cross(Vec3 from, Vec3 to) const;
  /// Returns the first surface on a ray, at most `within` metres away, which may be infinite. `direction` is a unit
  /// vector. Touching an edge counts as a hit. At equal distances, the obstacle with the lower index is returned.
  std::optional<Hit> first_hit(Vec3 origin, Vec3 direction, double within) const;
  /// Returns true if there is any such surface. Cheaper than first_hit().
  bool block(Vec3 origin, Vec3 direction, double within) const;
  /// Returns the unit vector from the nearest surface to a position. On a surface it is the outward normal; inside a
  /// body it points toward the surface. Returns nothing if there are no obstacles.
  std::optional<Vec3> away_from_surface(Vec3 position) const;
  /// Returns the distance from a position to the nearest surface in metres; infinite without obstacles.
  double distance_to_surface(Vec3 position) const;
  /// Returns the centroid of an obstacle's volume, projected to the ground (y = 0). Uses the surface of broken
  /// obstacles.
  Vec3 ground_centroid(std::size_t obstacle) const;

 private:
  struct Content;
  std::shared_ptr<const Content> content_;
};

/// Returns, for each of `positions`, 1 if it is inside an obstacle, else 0. Uses all threads. Throws Cancelled.
std::vector<std::uint8_t> inside_of(const Obstacles& obstacles, std::span<const Vec3> places, const Progress& progress);

}  // namespace meristem
