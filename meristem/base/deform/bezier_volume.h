// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "meristem/base/deform/space_map.h"

namespace meristem {

/// A Bézier volume over a box. It maps each point to the mean of its control points, weighted by the Bernstein
/// polynomials of the point's position in the box.
///
/// Beyond the box, the polynomials continue as straight lines, with the value and slope at the side of the box. The map
/// and its Jacobian are therefore continuous everywhere. A map of degree 1 is trilinear everywhere.
///
/// Based on: T. W. Sederberg, S. R. Parry: Free-form deformation of solid geometric models (SIGGRAPH 1986).
class BezierVolume : public SpaceMap {
 public:
  using Degree = std::array<int, 3>;  ///< along x, y and z, each from 1 to 3

  static std::size_t point_count(const Degree& degree);
  /// Returns the positions of control points that move nothing, spread evenly over the box. The order is layer by layer
  /// from the lowest y up, in each layer row by row toward +z, in each row toward +x.
  static std::vector<DVec3> points_at_rest(const DVec3& low, const DVec3& high, const Degree& degree);

  /// `low` and `high` are the corners of the box, low below high in all three coordinates. `points` are the control
  /// points (metres) in the order of points_at_rest. Throws std::invalid_argument for any other number of points.
  BezierVolume(const DVec3& low, const DVec3& high, const Degree& degree, const std::vector<DVec3>& points);

  void map(std::span<DVec3> points, std::span<DMat3> jacobians) const override;
  void add_to(Fingerprint& fingerprint) const override;

 private:
  void map_one(DVec3& point, DMat3& jacobian) const;

  DVec3 low_;
  DVec3 size_;
  Degree degree_;
  std::vector<DVec3> shifts_;  // shift of each control point from its position at rest
};

}  // namespace meristem
