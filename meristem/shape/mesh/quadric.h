// SPDX-License-Identifier: Apache-2.0
// Squared distances from many planes, weighted by area, as one quadratic function of a position.
//
// Based on: M. Garland, P. Heckbert: Surface Simplification Using Quadric Error Metrics (1997), section 4.
#pragma once

#include "meristem/base/vec.h"

namespace meristem {

struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // the symmetric matrix A
  DVec3 linear{0};
  double constant = 0;

  /// Adds the plane through `point` at right angles to the unit vector `normal`.
  void add_plane(DVec3 normal, DVec3 point, double weight) {
    const double offset = -glm::dot(normal, point);
    const DVec3 weighted = weight * normal;
    xx += weighted.x * normal.x;
    xy += weighted.x * normal.y;
    xz += weighted.x * normal.z;
    yy += weighted.y * normal.y;
    yz += weighted.y * normal.z;
    zz += weighted.z * normal.z;
    linear += offset * weighted;
    constant += weight * offset * offset;
  }

  Quadric& operator+=(const Quadric& other) {
    xx += other.xx;
    xy += other.xy;
    xz += other.xz;
    yy += other.yy;
    yz += other.yz;
    zz += other.zz;
    linear += other.linear;
    constant += other.constant;
    return *this;
  }

  /// Returns the sum of all weights. Each unit normal adds its weight to the trace.
  double weight() const { return xx + yy + zz; }

  /// Returns the weighted sum of squared distances.
  double at(DVec3 p) const {
    const double square =
        p.x * (xx * p.x + 2 * (xy * p.y + xz * p.z)) + p.y * (yy * p.y + 2 * yz * p.z) + zz * p.z * p.z;
    const double value = square + 2 * glm::dot(linear, p) + constant;
    return value > 0 ? value : 0;  // below 0 only by rounding
  }

  /// Returns the position of the minimum if a spring of `stiffness` (above 0, a share of the weight) pulls toward
  /// `rest`. The spring makes the minimum unique also for flat and straight parts.
  DVec3 min(DVec3 rest, double stiffness) const {
    const double spring = stiffness * weight();
    const double a = xx + spring;
    const double b = yy + spring;
    const double c = zz + spring;
    const DVec3 right = spring * rest - linear;
    // Cramer's rule with the cofactors of the symmetric matrix, which is positive definite because of the spring.
    const double aa = b * c - yz * yz;
    const double ab = xz * yz - xy * c;
    const double ac = xy * yz - xz * b;
    const double bb = a * c - xz * xz;
    const double bc = xy * xz - a * yz;
    const double cc = a * b - xy * xy;
    const double determinant = a * aa + xy * ab + xz * ac;
    if (!(determinant > 0)) return rest;
    return (1 / determinant) * DVec3(aa * right.x + ab * right.y + ac * right.z,
                                     ab * right.x + bb * right.y + bc * right.z,
                                     ac * right.x + bc * right.y + cc * right.z);
  }
};

}  // namespace meristem
