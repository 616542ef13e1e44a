// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "meristem/base/deform/space_map.h"

namespace meristem {

/// A Bézier volume over a box, which takes each point of it to the mean of its control points, weighted by Bernstein's
/// polynomials of the point's place in the box.
///
/// Beyond the box each side's polynomials go on straight, with the value and slope that they have at its end: the map
/// and its Jacobian are continuous everywhere, and one of degree 1 is the same trilinear map everywhere.
///
/// Based on: T. W. Sederberg, S. R. Parry: Free-form deformation of solid geometric models (SIGGRAPH 1986).
class BezierVolume : public SpaceMap {
 public:
  using Degree = std::array<int, 3>;  ///< along x, y and z, each from 1 to 3

  static std::size_t point_count(const Degree& degree);
  /// Where control points stand that move nothing: evenly in the box, layer by layer from its lowest y up, in each
  /// layer row by row toward +z, in each row toward +x.
  static std::vector<DVec3> points_at_rest(const DVec3& low, const DVec3& high, const Degree& degree);

  /// The box's corners, low below high in all three, and its control points (metres) in the order of points_at_rest.
  /// Another number of points is a std::invalid_argument.
  BezierVolume(const DVec3& low, const DVec3& high, const Degree& degree, const std::vector<DVec3>& points);

  void map(std::span<DVec3> points, std::span<DMat3> jacobians) const override;
  void add_to(Fingerprint& fingerprint) const override;

 private:
  void map_one(DVec3& point, DMat3& jacobian) const;

  DVec3 low_;
  DVec3 size_;
  Degree degree_;
  std::vector<DVec3> shifts_;  // of the control points, from where they stand at rest
};

}  // namespace meristem
