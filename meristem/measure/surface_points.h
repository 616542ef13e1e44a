// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meristem/base/mesh.h"

namespace meristem {

/// Positions on triangles, in proportion to area. Numbers that are evenly spread over the unit square give positions
/// that are evenly spread over the surface.
class SurfacePoints {
 public:
  struct Point {
    std::uint32_t triangle = 0;  ///< index into the mesh's triangles
    Vec3 weights{1, 0, 0};       ///< weights of the triangle's three vertices
  };

  /// Uses all triangles except the first `first` ones. `mesh` must outlive this object.
  explicit SurfacePoints(const Mesh& mesh, std::uint32_t first = 0);
  /// Uses only triangles that face toward a direction.
  SurfacePoints(const Mesh& mesh, DVec3 toward);

  /// Returns the area of the triangles in square metres.
  double area() const { return area_before_.empty() ? 0 : area_before_.back(); }
  /// Returns a position. `along` is the share of the area that comes before the position: earlier triangles and a part
  /// of its own triangle. `across` places the position across this order. Both must be in [0, 1). The area must be
  /// above 0.
  Point at(double along, double across) const;
  Vec3 position(const Point& place) const;

 private:
  void add(std::uint32_t triangle, double area);

  const Mesh& mesh_;
  std::vector<std::uint32_t> triangles_;
  std::vector<double> area_before_;  // summed area of the triangles up to and including each triangle
};

/// Returns the fractional part of a number from 0.
double fraction(double number);

/// Step whose multiples fill the unit interval most evenly: the golden ratio.
inline constexpr double kGoldenStep = 0.61803398874989485;
/// The two steps that fill the unit square evenly.
///
/// Based on: M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018.
inline constexpr std::array<double, 2> kSquareSteps{0.75487766624669276, 0.56984029099805327};

}  // namespace meristem
