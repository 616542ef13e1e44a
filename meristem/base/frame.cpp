// SPDX-License-Identifier: Apache-2.0
// Computes rotations and frames in doubles, rounded once at the end. A product of many frames therefore drifts only by
// the rounding of its factors.
#include "meristem/base/frame.h"

#include <cmath>

#include <glm/matrix.hpp>

#include "meristem/base/math.h"

namespace meristem {

namespace {

/// Returns `vector` with length 1, or `fallback` if it has no direction.
DVec3 unit_or(DVec3 vector, DVec3 fallback) {
  const double length = std::sqrt(glm::dot(vector, vector));
  return length >= 1e-20 && std::isfinite(length) ? vector / length : fallback;
}

/// Returns a unit vector at right angles to `n`. The choice jumps at one direction, which is straight down here.
///
/// Based on: J. R. Frisvad: Building an orthonormal basis from a 3D unit vector without normalization (2012).
DVec3 perpendicular(DVec3 n) {
  const double level = n.x * n.x + n.z * n.z;
  if (n.y < 0 && level < 1e-24) return {1, 0, 0};
  // Computes 1 + y without cancellation near y = -1.
  const double one_plus_y = n.y < 0 ? level / (1 - n.y) : 1 + n.y;
  return unit_or({1 - n.x * n.x / one_plus_y, -n.x, -n.x * n.z / one_plus_y}, {1, 0, 0});
}

/// Returns the half turn about a unit axis.
DMat3 half_turn(DVec3 axis) { return 2.0 * glm::outerProduct(axis, axis) - DMat3(1); }

}  // namespace

Vec3 Frame::normal(Vec3 local) const {
  // The cofactor matrix turns normals correctly for any axes, also singular ones. A mirror changes its sign.
  const DMat3 m(axes);
  const DMat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  const double side = glm::dot(m[0], cofactors[0]) < 0 ? -1 : 1;
  return Vec3(unit_or(side * (cofactors * DVec3(local)), DVec3(local)));
}

Mat3 rotation(Vec3 axis, double angle) { return Mat3(exact_rotation(DVec3(axis), angle)); }

DMat3 exact_rotation(DVec3 axis, double angle) {
  const DVec3 a = unit_or(axis, DVec3(kUp));
  const double sine = math::sin(angle);
  const double cosine = math::cos(angle);
  const DMat3 cross(DVec3(0, a.z, -a.y), DVec3(-a.z, 0, a.x), DVec3(a.y, -a.x, 0));
  return cosine * DMat3(1) + sine * cross + (1 - cosine) * glm::outerProduct(a, a);
}

Mat3 rotation_between(Vec3 from, Vec3 to) {
  const DVec3 start = unit_or(DVec3(from), DVec3(kUp));
  const DVec3 end = unit_or(DVec3(to), DVec3(kUp));
  const DVec3 middle = start + end;
  if (glm::dot(middle, middle) < 1e-18) return Mat3(half_turn(perpendicular(start)));
  // A half turn about the start, then one about the middle, make twice the turn from start to middle.
  return Mat3(half_turn(glm::normalize(middle)) * half_turn(start));
}

Mat3 rotation_toward(Vec3 from, Vec3 target, double share, Vec3 fallback) {
  if (share < 0) target = -target;
  const Vec3 axis = normalized_or(glm::cross(from, target), fallback);
  return rotation(axis, math::acos(glm::dot(from, target)) * std::abs(share));
}

Frame frame_along(Vec3 origin, Vec3 heading, Vec3 upper) {
  const DVec3 y = unit_or(DVec3(heading), DVec3(kUp));
  const DVec3 wanted = unit_or(DVec3(upper), DVec3(0));
  const DVec3 across = wanted - glm::dot(wanted, y) * y;
  const DVec3 z = glm::dot(across, across) < 1e-12 ? perpendicular(y) : glm::normalize(across);
  return {Mat3(DMat3(glm::cross(y, z), y, z)), origin};
}

Vec3 any_perpendicular(Vec3 direction) { return Vec3(perpendicular(unit_or(DVec3(direction), DVec3(kUp)))); }

Vec3 normalized_or(Vec3 vector, Vec3 fallback) { return Vec3(unit_or(DVec3(vector), DVec3(fallback))); }

}  // namespace meristem
