// SPDX-License-Identifier: Apache-2.0
// Finds the nearest rotation by Newton's iteration: the mean of a matrix and its transposed inverse is nearer to a
// rotation than the matrix. Until the matrix is near a rotation, both are scaled to equal size first.
#include "meristem/base/deform/polar.h"

#include <cmath>

#include <glm/matrix.hpp>

namespace meristem {

namespace {

constexpr int kMaxSteps = 40;           // a stretch of 1e12 needs 12 steps
constexpr double kNearRotation = 1e-2;  // below this squared change, each step doubles the number of exact digits
                                        // without scaling
constexpr double kDone = 1e-15;         // change at which the iteration stops

double squared_size(const DMat3& m) { return glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]); }

}  // namespace

DMat3 nearest_rotation(const DMat3& matrix) {
  DMat3 m = matrix;
  bool is_near = false;
  for (int step = 0; step < kMaxSteps; ++step) {
    const DMat3 other = glm::transpose(glm::inverse(m));
    const double change = squared_size(m - other);
    if (!(change > kDone * kDone)) break;
    const double scale = is_near ? 1 : std::sqrt(std::sqrt(squared_size(other) / squared_size(m)));
    m = 0.5 * (scale * m + other / scale);
    is_near = change < kNearRotation;
  }
  return m;
}

}  // namespace meristem
