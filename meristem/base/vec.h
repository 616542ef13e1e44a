// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

namespace meristem {

// Geometry is stored in 32-bit floats. Sums over many items use the 64-bit types.
using Vec2 = glm::vec2;    ///< two 32-bit floats
using Vec3 = glm::vec3;    ///< three 32-bit floats
using Vec4 = glm::vec4;    ///< four 32-bit floats
using Mat3 = glm::mat3;    ///< 3 columns of three 32-bit floats
using DVec3 = glm::dvec3;  ///< three 64-bit floats
using DMat3 = glm::dmat3;  ///< 3 columns of three 64-bit floats

inline constexpr Vec3 kUp{0, 1, 0};                    ///< direction against gravity: +y
inline constexpr double kPi = 3.14159265358979323846;  ///< half a turn in radians
/// The angle of most spiral phyllotaxes, 360° / φ², in degrees.
inline constexpr double kGoldenAngleDeg = 137.50776405003785;

/// Converts degrees to radians.
constexpr double radians(double degrees) { return degrees * (kPi / 180); }
/// Converts radians to degrees.
constexpr double degrees(double radians) { return radians * (180 / kPi); }

/// Returns the squared length. The horizontal parts are added first, so that a right-angled turn about the vertical
/// changes no bit.
inline float squared_length(Vec3 v) { return (v.x * v.x + v.z * v.z) + v.y * v.y; }
inline double squared_length(DVec3 v) { return (v.x * v.x + v.z * v.z) + v.y * v.y; }

/// Axis-aligned box, metres. Empty (low > high) until a point is added.
struct Box {
  Vec3 low{std::numeric_limits<float>::infinity()};    ///< corner with the lowest coordinates
  Vec3 high{-std::numeric_limits<float>::infinity()};  ///< corner with the highest coordinates

  /// Extends the box so that it holds a point, or another box.
  void add(Vec3 point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  void add(const Box& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  /// Returns true if nothing was added.
  bool is_empty() const { return !(low.x <= high.x); }
  /// Returns true if a point is in the box or on its faces.
  bool holds(Vec3 point) const {
    return glm::all(glm::lessThanEqual(low, point)) && glm::all(glm::lessThanEqual(point, high));
  }
  /// Returns the middle of the box, which must not be empty.
  Vec3 centre() const { return 0.5F * (low + high); }
  Vec3 size() const { return is_empty() ? Vec3(0) : high - low; }  ///< lengths of the sides
};

}  // namespace meristem
