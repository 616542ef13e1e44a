// SPDX-License-Identifier: Apache-2.0
// Deformations of what has grown: maps of space in the frames of those that give them, one within another.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/deform/space_map.h"
#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"

namespace meristem {

/// What a deformation does to shapes.
enum class DeformedPart {
  geometry,  ///< all vertices go where it takes them
  axes,      ///< stems' axes go there, and are as thick as before; organs are turned and moved with it as they are
};

/// Maps of world space, the innermost first.
///
/// Stems are bent by those on axes up to the first one on geometry; from there on all of them act on their surfaces.
/// Organs follow each by what it acts on.
class Deformation {
 public:
  /// One map of space, and what it acts on.
  struct Level {
    std::shared_ptr<const SpaceMap> map;         ///< not null
    Frame frame;                                 ///< in which the map works
    DeformedPart part = DeformedPart::geometry;  ///< whether the map bends whole shapes or axes alone
    std::string path;                            ///< of who gives it, for faults
  };
  /// At least one.
  explicit Deformation(std::vector<Level> levels) : levels_(std::move(levels)) {}

  /// All maps, the innermost first.
  std::span<const Level> levels() const { return levels_; }
  /// One within another; either may be null.
  static std::shared_ptr<const Deformation> nested(const std::shared_ptr<const Deformation>& inner,
                                                   const std::shared_ptr<const Deformation>& outer);
  /// The levels that bend the axes of stems, or null.
  std::shared_ptr<const Deformation> of_axes() const;
  /// The levels that act on the surfaces of stems, which follow the levels of `of_axes()`, or null.
  std::shared_ptr<const Deformation> of_surface() const;
  /// Moves all as if it were rigid: as the deformation moves and turns a frame at that position. Throws as `map` does.
  std::shared_ptr<const Deformation> rigid_at(Vec3 position, std::string_view who) const;
  /// The same deformation of a world that stands at `frame` in another one.
  std::shared_ptr<const Deformation> moved_to(const Frame& frame) const;

  /// Moves points by all levels, and writes the Jacobian at each, as it was. Throws InputError at the path of a level
  /// that folds space over (its Jacobian's determinant is not above 0), has no finite value or takes the point out of
  /// the world; `who` stands at the points.
  void map(std::span<DVec3> points, std::span<DMat3> jacobians, std::string_view who) const;
  /// The same by one level.
  static void map(const Level& level, std::span<DVec3> points, std::span<DMat3> jacobians, std::string_view who);
  /// Moves positions by all levels, on all threads.
  void map(std::span<Vec3> positions, std::string_view who) const;
  /// Moves a mesh whose vertices count from `origin` in the world; after it they count from `new_origin`. Normals and
  /// tangents turn along. On all threads.
  void map(Mesh& mesh, Vec3 origin, Vec3 new_origin, std::string_view who) const;

  std::uint64_t hash() const;  ///< of all that it depends on but the paths

 private:
  std::vector<Level> levels_;
};

}  // namespace meristem
