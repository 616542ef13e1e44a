// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "meristem/base/vec.h"

namespace meristem {

/// A ray that meets triangles in double precision without a gap between neighbours. Triangles with a common edge or
/// vertex are decided by the same signs. Touching counts as a hit.
class WatertightRay {
 public:
  using Corner = std::array<double, 3>;

  /// `direction` may have any length above 0. Distances are in units of this length.
  WatertightRay(DVec3 origin, DVec3 direction);

  /// Returns the first distance at which a triangle is met, in [0, within]; `within` may be infinite. Both faces count.
  std::optional<double> distance_to(const std::array<Corner, 3>& triangle, double within) const;

 private:
  /// A corner in the ray's coordinates: the ray runs along z from the origin.
  struct Seen {
    double x;
    double y;
    double z;
  };
  Seen seen(const Corner& corner) const;
  static std::optional<double> distance_in_plane(const std::array<Seen, 3>& corners, double within);

  Corner origin_;
  std::size_t x_ = 0;  // the axes that become x, y and z
  std::size_t y_ = 1;
  std::size_t z_ = 2;
  double shear_x_ = 0;
  double shear_y_ = 0;
  double scale_ = 1;
};

}  // namespace meristem
