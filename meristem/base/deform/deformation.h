// SPDX-License-Identifier: Apache-2.0
// Deformations of grown shapes: maps of space, each in the frame of the instance that sets it, one nested in another.
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

/// The part of shapes on which a deformation acts.
enum class DeformedPart {
  geometry,  ///< moves all vertices
  axes,      ///< moves the axes of stems, but keeps their thickness; moves and turns organs without a change of shape
};

/// Maps of world space, the innermost first.
///
/// Maps on axes bend stems, up to the first map on geometry. This map and all later maps act on the surfaces of stems.
/// Organs follow each map according to its part.
class Deformation {
 public:
  /// One map of space and the part on which it acts.
  struct Level {
    std::shared_ptr<const SpaceMap> map;         ///< not null
    Frame frame;                                 ///< frame of the map's coordinates
    DeformedPart part = DeformedPart::geometry;  ///< whether the map deforms whole shapes or only axes
    std::string path;                            ///< path of the instance that sets the map, for error messages
  };
  /// `levels` must have at least one entry.
  explicit Deformation(std::vector<Level> levels) : levels_(std::move(levels)) {}

  /// Returns all maps, the innermost first.
  std::span<const Level> levels() const { return levels_; }
  /// Returns one deformation nested in another. Either may be null.
  static std::shared_ptr<const Deformation> nested(const std::shared_ptr<const Deformation>& inner,
                                                   const std::shared_ptr<const Deformation>& outer);
  /// Returns the levels that bend the axes of stems, or null if there are no such levels.
  std::shared_ptr<const Deformation> of_axes() const;
  /// Returns the levels that act on the surfaces of stems, after the levels of `of_axes()`. Returns null if there are
  /// no such levels.
  std::shared_ptr<const Deformation> of_surface() const;
  /// Returns a rigid deformation that moves and turns everything as this one moves and turns a frame at `position`.
  /// Throws like `map`.
  std::shared_ptr<const Deformation> rigid_at(Vec3 position, std::string_view who) const;
  /// Returns this deformation for a world that stands at `frame` in another world.
  std::shared_ptr<const Deformation> moved_to(const Frame& frame) const;

  /// Moves points through all levels, and writes the Jacobian of the whole map at each original point. Throws
  /// InputError at the path of a level that folds space over (the determinant of the Jacobian is not above 0), has no
  /// finite value or moves a point too far away. `who` names the object at the points in messages.
  void map(std::span<DVec3> points, std::span<DMat3> jacobians, std::string_view who) const;
  /// Moves points through one level only, like the function above.
  static void map(const Level& level, std::span<DVec3> points, std::span<DMat3> jacobians, std::string_view who);
  /// Moves positions through all levels, on all threads.
  void map(std::span<Vec3> positions, std::string_view who) const;
  /// Moves a mesh whose vertices are relative to `origin` in the world. Afterwards they are relative to `new_origin`.
  /// Normals and tangents turn along. Runs on all threads.
  void map(Mesh& mesh, Vec3 origin, Vec3 new_origin, std::string_view who) const;

  std::uint64_t hash() const;  ///< hash of everything that has an effect, without the paths

 private:
  std::vector<Level> levels_;
};

}  // namespace meristem
