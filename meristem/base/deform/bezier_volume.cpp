// SPDX-License-Identifier: Apache-2.0
// Maps points by a Bézier volume. Control points at rest give the identity, so only the shifts from their positions at
// rest are added up. Where nothing is shifted, no bit of a point changes.
#include "meristem/base/deform/bezier_volume.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace meristem {

namespace {

/// The Bernstein polynomials of one degree at one position, and their slopes.
struct Weights {
  std::array<double, 4> value{};
  std::array<double, 4> slope{};
};

Weights weights_at(double place, int degree) {
  const double t = std::clamp(place, 0.0, 1.0);
  const double s = 1 - t;
  Weights weights;
  switch (degree) {
    case 1:
      weights = {{s, t}, {-1, 1}};
      break;
    case 2:
      weights = {{s * s, 2 * s * t, t * t}, {-2 * s, 2 * (s - t), 2 * t}};
      break;
    default:
      weights = {{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
                 {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t}};
  }
  for (std::size_t k = 0; k < 4; ++k) weights.value[k] += (place - t) * weights.slope[k];
  return weights;
}

std::size_t side(int degree) { return static_cast<std::size_t>(degree) + 1; }

/// A sum of shifts, and its derivatives along x and z.
struct Sum {
  DVec3 value{0};
  DVec3 by_x{0};
  DVec3 by_z{0};
};

}  // namespace

std::size_t BezierVolume::point_count(const Degree& degree) {
  return side(degree[0]) * side(degree[1]) * side(degree[2]);
}

std::vector<DVec3> BezierVolume::points_at_rest(const DVec3& low, const DVec3& high, const Degree& degree) {
  const auto place = [&](int axis, int k) {
    const int last = degree[static_cast<std::size_t>(axis)];
    return k == last ? high[axis] : low[axis] + (high[axis] - low[axis]) * k / last;
  };
  std::vector<DVec3> points;
  for (int y = 0; y <= degree[1]; ++y) {
    for (int z = 0; z <= degree[2]; ++z) {
      for (int x = 0; x <= degree[0]; ++x) points.emplace_back(place(0, x), place(1, y), place(2, z));
    }
  }
  return points;
}

BezierVolume::BezierVolume(const DVec3& low, const DVec3& high, const Degree& degree, const std::vector<DVec3>& points)
    : low_(low), size_(high - low), degree_(degree), shifts_(points) {
  if (points.size() != point_count(degree)) throw std::invalid_argument("a Bézier volume has another number of points");
  const std::vector<DVec3> rest = points_at_rest(low, high, degree);
  for (std::size_t k = 0; k < rest.size(); ++k) shifts_[k] -= rest[k];
}

void BezierVolume::map(std::span<DVec3> points, std::span<DMat3> jacobians) const {
  assert(points.size() == jacobians.size());
  for (std::size_t k = 0; k < points.size(); ++k) map_one(points[k], jacobians[k]);
}

void BezierVolume::map_one(DVec3& point, DMat3& jacobian) const {
  const DVec3 place = (point - low_) / size_;
  const Weights x = weights_at(place.x, degree_[0]);
  const Weights y = weights_at(place.y, degree_[1]);
  const Weights z = weights_at(place.z, degree_[2]);
  DVec3 shift(0), by_x(0), by_y(0), by_z(0);
  const DVec3* next = shifts_.data();
  for (std::size_t iy = 0; iy < side(degree_[1]); ++iy) {
    Sum layer;
    for (std::size_t iz = 0; iz < side(degree_[2]); ++iz) {
      DVec3 row(0), row_by_x(0);
      for (std::size_t ix = 0; ix < side(degree_[0]); ++ix, ++next) {
        row += x.value[ix] * *next;
        row_by_x += x.slope[ix] * *next;
      }
      layer.value += z.value[iz] * row;
      layer.by_x += z.value[iz] * row_by_x;
      layer.by_z += z.slope[iz] * row;
    }
    shift += y.value[iy] * layer.value;
    by_x += y.value[iy] * layer.by_x;
    by_z += y.value[iy] * layer.by_z;
    by_y += y.slope[iy] * layer.value;
  }
  point += shift;
  jacobian = DMat3(1) + DMat3(by_x / size_.x, by_y / size_.y, by_z / size_.z);
}

void BezierVolume::add_to(Fingerprint& fingerprint) const {
  for (const DVec3& corner : {low_, size_}) fingerprint.add(corner.x).add(corner.y).add(corner.z);
  for (const int degree : degree_) fingerprint.add(degree);
  fingerprint.add_array(shifts_);
}

}  // namespace meristem
