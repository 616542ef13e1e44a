// SPDX-License-Identifier: Apache-2.0
// Signed distances, negative inside, and the operations on them, at one position. They have no branches where compilers
// can then process several positions at once. T is float or double.
//
// Based on: F. Heuer: Algorithmische Erzeugung von 3D-Low-Poly-Bäumen (2022), equations 2.12 and 2.13; A. Pasko, V.
// Savchenko: Blending operations for the functionally based constructive geometry (1994); I. Quilez: Smooth minimum
// (2013). The distances are derived here.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace meristem::distance {

/// A vector of three numbers of type T.
template <class T>
using V3 = glm::vec<3, T>;

/// The union of all balls around the points of a segment, whose radii change evenly along it.
template <class T>
struct RoundCone {
  V3<T> origin{0};  ///< on the axis
  V3<T> axis{0};    ///< unit vector
  T low = 0;        ///< start of the segment, along the axis from the origin
  T high = 0;       ///< end of the segment, along the axis from the origin
  T radius = 0;     ///< radius at the origin
  T slope = 0;      ///< decrease of the radius along the axis, which is the sine of the flank's angle, in (-1, 1)
  T tangent = 0;    ///< tangent of the flank's angle

  /// Returns the distance from the position (x, y, z) to the surface, negative inside.
  T distance(T x, T y, T z) const {
    const T dx = x - origin.x;
    const T dy = y - origin.y;
    const T dz = z - origin.z;
    const T along = dx * axis.x + dy * axis.y + dz * axis.z;
    const T across2 = std::max(T(0), dx * dx + dy * dy + dz * dz - along * along);
    // The nearest ball lies where the flank's normal through the position meets the axis.
    const T centre = std::min(std::max(along - std::sqrt(across2) * tangent, low), high);
    const T rest = along - centre;
    return std::sqrt(across2 + rest * rest) - (radius - slope * centre);
  }
};

/// A cone between two flat discs.
template <class T>
struct FlatCone {
  V3<T> origin{0};    ///< in the middle of the axis
  V3<T> axis{0};      ///< unit vector
  T half = 0;         ///< half of the length
  T low_radius = 0;   ///< radius of the disc at the end against the axis
  T high_radius = 0;  ///< radius of the disc at the end along the axis

  /// Returns the distance from the position (x, y, z) to the surface, negative inside.
  T distance(T x, T y, T z) const {
    const T dx = x - origin.x;
    const T dy = y - origin.y;
    const T dz = z - origin.z;
    const T along = dx * axis.x + dy * axis.y + dz * axis.z;
    // Far along the axis, differences of squares would lose digits.
    const T ax = dx - along * axis.x;
    const T ay = dy - along * axis.y;
    const T az = dz - along * axis.z;
    const T across = std::sqrt(ax * ax + ay * ay + az * az);
    // Distance to the nearer disc, then to the flank, in the half-plane through the axis.
    const T disc = along < 0 ? low_radius : high_radius;
    const T off_disc = across - std::min(across, disc);
    const T beyond = std::abs(along) - half;
    const T run_x = high_radius - low_radius;
    const T run_y = 2 * half;
    const T from_x = across - low_radius;
    const T from_y = along + half;
    const T share = std::min(std::max((from_x * run_x + from_y * run_y) / (run_x * run_x + run_y * run_y), T(0)), T(1));
    const T flank_x = from_x - share * run_x;
    const T flank_y = from_y - share * run_y;
    const T nearest = std::sqrt(std::min(off_disc * off_disc + beyond * beyond, flank_x * flank_x + flank_y * flank_y));
    const bool is_inside = beyond < 0 && from_x * run_y - from_y * run_x < 0;
    return is_inside ? -nearest : nearest;
  }
};

/// A box with any rotation.
template <class T>
struct Box {
  V3<T> origin{0};            ///< the centre
  glm::mat<3, 3, T> axes{1};  ///< columns: unit vectors along the edges
  V3<T> half{0};              ///< half lengths of the edges

  /// Returns the distance from the position (x, y, z) to the surface, negative inside.
  T distance(T x, T y, T z) const {
    const V3<T> d = V3<T>(x, y, z) - origin;
    const V3<T> out(std::abs(glm::dot(d, axes[0])) - half.x, std::abs(glm::dot(d, axes[1])) - half.y,
                    std::abs(glm::dot(d, axes[2])) - half.z);
    const T ox = std::max(out.x, T(0));
    const T oy = std::max(out.y, T(0));
    const T oz = std::max(out.z, T(0));
    return std::sqrt(ox * ox + oy * oy + oz * oz) + std::min(std::max(out.x, std::max(out.y, out.z)), T(0));
  }
};

/// An ellipsoid with any rotation.
template <class T>
struct Ellipsoid {
  V3<T> origin{0};            ///< the centre
  glm::mat<3, 3, T> axes{1};  ///< columns: unit vectors along the half axes
  V3<T> radii{1};             ///< half axes

  /// Returns the distance from the position to the surface, negative inside. The nearest point is r²p / (t + r²), with
  /// the t that puts it onto the surface. This t is the root of a convex function, which Newton's method reaches from
  /// below. The iteration uses u = t + the smallest r², so that positions near the plane across the thinnest axis lose
  /// no digits.
  T distance(T x, T y, T z) const {
    const V3<T> d = V3<T>(x, y, z) - origin;
    const glm::dvec3 place(std::abs(glm::dot(d, axes[0])), std::abs(glm::dot(d, axes[1])),
                           std::abs(glm::dot(d, axes[2])));
    const glm::dvec3 r(radii);
    const int thin = r.x <= r.y ? (r.x <= r.z ? 0 : 2) : (r.y <= r.z ? 1 : 2);
    const glm::dvec3 more = r * r - r[thin] * r[thin];
    const glm::dvec3 start = r * place - more;
    double u = std::max(start.x, std::max(start.y, start.z));
    glm::dvec3 share{0};  // the nearest point divided by the radii
    double slope = 0;
    const auto excess_at = [&](double at) {
      slope = 0;
      for (int k = 0; k < 3; ++k) {
        if (!(place[k] > 0)) continue;
        share[k] = r[k] * place[k] / (at + more[k]);
        slope += share[k] * share[k] / (at + more[k]);
      }
      return glm::dot(share, share) - 1;
    };
    double excess = excess_at(u);
    for (int step = 0; step < 64 && excess > 0; ++step) {
      const double next = u + 0.5 * excess / slope;
      if (!(next > u)) break;
      u = next;
      excess = excess_at(u);
    }
    // On the plane across the thinnest axis, near the middle, two points are nearest: one above and one below.
    if (u <= 0 && excess < 0) share[thin] = std::sqrt(-excess);
    const double gap = glm::distance(place, r * share);
    const bool is_inside = glm::dot(place / r, place / r) < 1;
    return static_cast<T>(is_inside ? -gap : gap);
  }
};

/// A union with a fillet of size `width` where two bodies meet. At most width / 4 below the smaller distance.
template <class T>
T blend_poly(T a, T b, T width, T over_four_widths) {
  const T near = std::max(width - std::abs(a - b), T(0));
  return std::min(a, b) - near * near * over_four_widths;
}

/// Heuer's union: below the smaller distance everywhere, by width / 2 if both are equal.
template <class T>
T blend_root(T a, T b, T width) {
  return T(0.5) * (a + b - std::sqrt((a - b) * (a - b) + width * width));
}

/// A sharp union (Pasko's equation for alpha = 1) minus his displacement, which is width / 4 where both are 0.
template <class T>
T blend_pasko(T a, T b, T width) {
  return std::min(a, b) - T(0.25) * width * width * width / (width * width + a * a + b * b);
}

}  // namespace meristem::distance
