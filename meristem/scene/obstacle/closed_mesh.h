// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

/// Triangles of a file, counter-clockwise seen from outside; in double precision, like point clouds.
struct TriangleMesh {
  std::vector<DVec3> positions;                         ///< metres
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< three vertices each, as indices into `positions`
};

/// Returns the reasons why a mesh is not closed, each with its number of occurrences and first position. Reasons are
/// open edges, edges with more triangles in one direction than in the other, and triangles with reversed orientation.
/// Returns an empty list for closed meshes. Vertices at equal positions count as one. Triangles without area are
/// ignored.
std::vector<std::string> closedness_errors(const TriangleMesh& mesh);

/// Returns the reason why a closed mesh is not a body, such as "encloses nothing"; empty for bodies. A mesh that
/// crosses itself, like a bow tie, may have no volume, because inverted parts cancel others.
std::string body_error(const TriangleMesh& mesh);

/// A closed mesh with an exact test for inside. A point is inside if the winding number of the surface around it is not
/// 0. The inside therefore does not depend on the orientation of the mesh. A shell within a shell makes a hollow if it
/// faces inward and has no effect if it faces outward. Overlapping bodies count as one.
///
/// The test has no gaps along edges and vertices: positions are rounded to a grid of 2^26 steps per side of the bounds,
/// and decisions use whole numbers.
class ClosedMesh {
 public:
  /// Accepts any mesh whose indices are in range, else throws std::invalid_argument. Results are meaningful for closed
  /// meshes only.
  explicit ClosedMesh(const TriangleMesh& mesh);

  bool contains(DVec3 point) const { return winding_number(point) != 0; }  ///< true if the point is inside
  /// Returns how often the surface winds around a point: 1 inside a simple body that faces outward.
  int winding_number(DVec3 point) const;

  double volume() const { return volume_; }                           ///< cubic units, at least 0
  const std::vector<DVec3>& positions() const { return positions_; }  ///< metres
  std::size_t triangle_count() const { return triangles_.size(); }    ///< number of triangles
  TriangleMesh mesh() const { return {positions_, triangles_}; }      ///< a copy

 private:
  using Grid3 = std::array<std::int32_t, 3>;
  struct Level {
    std::vector<std::uint32_t> begin;      // begin of each cell's part of `triangles`, and the end
    std::vector<std::uint32_t> triangles;  // triangle indices by cell
  };

  void build_levels();
  void add_crossing(const std::array<std::uint32_t, 3>& triangle, const Grid3& point, int& winding) const;

  std::vector<DVec3> positions_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Grid3> snapped_;  // positions on the grid
  DVec3 low_{0};
  DVec3 steps_{0};  // grid steps per unit along each axis
  std::vector<Level> levels_;
  double volume_ = 0;
};

}  // namespace meristem
