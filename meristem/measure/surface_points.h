// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meristem/base/mesh.h"

namespace meristem {

/// Positions on triangles in proportion to area. Numbers that are evenly spread over the unit square give positions
/// that are evenly spread over the surface.
class SurfacePoints {
 public:
  struct Point {
    std::uint32_t triangle = 0;  ///< index into the mesh's triangles
    Vec3 weights{1, 0, 0};       ///< of the triangle's three vertices
  };

  /// On all triangles but the `first` ones. `mesh` must outlive this.
  explicit SurfacePoints(const Mesh& mesh, std::uint32_t first = 0);
  /// On those triangles alone that face toward a direction.
  SurfacePoints(const Mesh& mesh, DVec3 toward);

  /// Square metres of the triangles.
  double area() const { return area_before_.empty() ? 0 : area_before_.back(); }
  /// Below the share `along` of the area lie the triangles before the position's own and a part of that one; `across`
  /// says where the position is at right angles to this. Both in [0, 1). Only where there is an area.
  Point at(double along, double across) const;
  Vec3 position(const Point& place) const;

 private:
  void add(std::uint32_t triangle, double area);

  const Mesh& mesh_;
  std::vector<std::uint32_t> triangles_;
  std::vector<double> area_before_;  // of the triangles up to and with each one
};

/// The part of a number from 0 behind its point.
double fraction(double number);

/// A number that is added again and again to fill the unit interval most evenly: the golden ratio's.
inline constexpr double kGoldenStep = 0.61803398874989485;
/// The two that fill the unit square.
///
/// Based on: M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018.
inline constexpr std::array<double, 2> kSquareSteps{0.75487766624669276, 0.56984029099805327};

}  // namespace meristem
