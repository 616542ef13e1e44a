// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/vec.h"

namespace meristem {

/// Triangles as a file has them, counter-clockwise seen from outside; in double, as for point clouds.
struct TriangleMesh {
  std::vector<DVec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// What keeps a mesh from being closed, each kind with its number and first position: open edges, edges where more
/// triangles meet one way than the other, triangles turned against their neighbours. Empty for closed meshes. Vertices
/// at one position count as one; triangles without area, which close nothing and open nothing, are passed over.
std::vector<std::string> closedness_faults(const TriangleMesh& mesh);

/// What keeps a closed mesh from being a body, as in "encloses nothing"; empty for bodies. One that crosses itself may
/// have as much inside that is turned inside out as there is else, like a bow tie, and then no volume.
std::string body_fault(const TriangleMesh& mesh);

/// A closed mesh that says what is inside it. A point is inside where the surface winds around it a number of times
/// that is not 0: so a mesh turned inside out has the same inside, a shell within a shell makes a hollow if it faces
/// inward and changes nothing if it faces outward, and bodies that overlap count as one.
///
/// Exact, so without holes or doubled layers along edges and vertices: everything is rounded to a grid of 2^26 steps a
/// side of the bounds, and decided in whole numbers.
class ClosedMesh {
 public:
  /// Any mesh whose indices are in range, else throws std::invalid_argument; answers mean something for closed ones.
  explicit ClosedMesh(const TriangleMesh& mesh);

  bool contains(DVec3 point) const { return winding_number(point) != 0; }
  /// How often the surface winds around a point; 1 inside a plain body that faces outward.
  int winding_number(DVec3 point) const;

  double volume() const { return volume_; }  ///< cubic units, at least 0
  const std::vector<DVec3>& positions() const { return positions_; }
  std::size_t triangle_count() const { return triangles_.size(); }
  TriangleMesh mesh() const { return {positions_, triangles_}; }  ///< a copy

 private:
  using Grid3 = std::array<std::int32_t, 3>;
  struct Level {
    std::vector<std::uint32_t> begin;      // beginning of each cell's part of `triangles`, and one more
    std::vector<std::uint32_t> triangles;  // by cell
  };

  void build_levels();
  void add_crossing(const std::array<std::uint32_t, 3>& triangle, const Grid3& point, int& winding) const;

  std::vector<DVec3> positions_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Grid3> snapped_;  // positions on the grid
  DVec3 low_{0};
  DVec3 steps_{0};  // grid steps a unit along each axis
  std::vector<Level> levels_;
  double volume_ = 0;
};

}  // namespace meristem
