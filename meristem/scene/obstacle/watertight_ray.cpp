// SPDX-License-Identifier: Apache-2.0
// Intersects rays with triangles without gaps between neighbours. The corners are sheared so that the ray runs along z.
// The ray meets the triangle if the plane's origin is on one side of its three edges. The sign for an edge is the sign
// of a difference of two products. Rounding may change it to 0 but never reverses it, and the neighbouring triangle
// gets exactly the opposite sign. Triangles seen edge-on are decided along z.
//
// Based on: S. Woop, C. Benthin, I. Wald, Watertight Ray/Triangle Intersection (2013).
#include "meristem/scene/obstacle/watertight_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meristem {

WatertightRay::WatertightRay(DVec3 origin, DVec3 direction) : origin_{origin.x, origin.y, origin.z} {
  const Corner along{direction.x, direction.y, direction.z};
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(along[k]) > std::abs(along[z_])) z_ = k;
  }
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  shear_x_ = along[x_] / along[z_];
  shear_y_ = along[y_] / along[z_];
  scale_ = 1 / along[z_];
}

WatertightRay::Seen WatertightRay::seen(const Corner& corner) const {
  const double z = corner[z_] - origin_[z_];
  return {corner[x_] - origin_[x_] - shear_x_ * z, corner[y_] - origin_[y_] - shear_y_ * z, scale_ * z};
}

std::optional<double> WatertightRay::distance_to(const std::array<Corner, 3>& triangle, double within) const {
  const Seen a = seen(triangle[0]);
  const Seen b = seen(triangle[1]);
  const Seen c = seen(triangle[2]);
  // Each is the weight of the corner opposite to its edge.
  const double weight_a = c.x * b.y - c.y * b.x;
  const double weight_b = a.x * c.y - a.y * c.x;
  const double weight_c = b.x * a.y - b.y * a.x;
  if ((weight_a < 0 || weight_b < 0 || weight_c < 0) && (weight_a > 0 || weight_b > 0 || weight_c > 0)) {
    return std::nullopt;
  }
  const double sum = weight_a + weight_b + weight_c;
  if (sum == 0) return distance_in_plane({a, b, c}, within);
  const double distance = (weight_a * a.z + weight_b * b.z + weight_c * c.z) / sum;
  if (!(distance >= 0 && distance <= within)) return std::nullopt;
  return distance;
}

std::optional<double> WatertightRay::distance_in_plane(const std::array<Seen, 3>& corners, double within) {
  // The triangle is seen edge-on, as a line. The ray is in the triangle between the points where edges pass over the
  // origin.
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -nearest;
  for (std::size_t k = 0; k < 3; ++k) {
    const Seen& from = corners[k];
    const Seen& to = corners[(k + 1) % 3];
    const bool by_x = std::abs(to.x - from.x) >= std::abs(to.y - from.y);
    const double begin = by_x ? from.x : from.y;
    const double end = by_x ? to.x : to.y;
    if (std::min(from.x, to.x) > 0 || std::max(from.x, to.x) < 0) continue;
    if (std::min(from.y, to.y) > 0 || std::max(from.y, to.y) < 0) continue;
    const double share = begin == end ? 0 : begin / (begin - end);
    const double z = from.z + share * (to.z - from.z);
    const double other = begin == end ? to.z : z;
    nearest = std::min({nearest, z, other});
    farthest = std::max({farthest, z, other});
  }
  const double distance = std::max(nearest, 0.0);
  if (!(distance <= farthest && distance <= within)) return std::nullopt;
  return distance;
}

}  // namespace meristem
