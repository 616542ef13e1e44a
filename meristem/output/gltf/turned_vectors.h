// SPDX-License-Identifier: Apache-2.0
// Turns normals and tangents of many vertices by one frame.
#pragma once

#include <cmath>

#include <glm/mat3x3.hpp>

#include "meristem/base/frame.h"

namespace meristem {

/// Computes the results of Frame::normal to the last bit, but prepares the matrix only once. Also computes tangents to
/// these normals.
class VectorTurner {
 public:
  explicit VectorTurner(const Frame& frame) : axes_(frame.axes) {
    const glm::dmat3 m(frame.axes);
    cofactors_ = glm::dmat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    side_ = glm::dot(m[0], cofactors_[0]) < 0 ? -1 : 1;
  }

  Vec3 normal(Vec3 local) const {
    const DVec3 vector = side_ * (cofactors_ * DVec3(local));
    const double length = std::sqrt(glm::dot(vector, vector));
    return length >= 1e-20 && std::isfinite(length) ? Vec3(vector / length) : local;
  }

  /// Returns the tangent at a vertex with the turned normal `normal`. A mirror flips the direction of v.
  Vec4 tangent(Vec4 local, Vec3 normal) const {
    const Vec3 along = axes_ * Vec3(local);
    const Vec3 tangent = normalized_or(along - normal * glm::dot(normal, along), any_perpendicular(normal));
    return Vec4(tangent, static_cast<float>(side_) * local.w);
  }

 private:
  Mat3 axes_;
  glm::dmat3 cofactors_;
  double side_;
};

}  // namespace meristem
