// SPDX-License-Identifier: Apache-2.0
// Finds the smallest bend by stepping over angles until the end is near enough, and then by bisection in the last step.
#include "meristem/grow/prune/draw.h"

#include "meristem/base/frame.h"
#include "meristem/base/math.h"

namespace meristem {

namespace {

constexpr double kMaxAngle = 0.75 * kPi;  // largest total bend of a shoot
constexpr int kSteps = 135;               // of one degree each
constexpr int kHalvings = 12;             // bisections of the last step

Vec3 end_of(std::span<const Vec3> points, Vec3 axis, double angle) {
  Vec3 end = points[0];
  const auto count = static_cast<double>(points.size() - 1);
  for (std::size_t k = 1; k < points.size(); ++k) {
    end += rotation(axis, angle * static_cast<double>(k) / count) * (points[k] - points[k - 1]);
  }
  return end;
}

}  // namespace

Draw draw_toward(std::span<const Vec3> points, Vec3 target, double gap) {
  const Vec3 across = glm::cross(points.back() - points.front(), target - points.front());
  if (squared_length(across) == 0) return {};
  Draw draw{normalized_or(across, Vec3(1, 0, 0)), 0};
  const auto distance = [&](double angle) { return glm::distance(end_of(points, draw.axis, angle), target); };
  double nearest = distance(0);
  if (nearest <= gap) return draw;
  for (int k = 1; k <= kSteps; ++k) {
    const double angle = kMaxAngle * k / kSteps;
    const double away = distance(angle);
    if (away >= nearest) return draw;  // past the nearest position
    nearest = away;
    if (away > gap) {
      draw.angle = angle;
      continue;
    }
    double low = draw.angle, high = angle;
    for (int half = 0; half < kHalvings; ++half) {
      const double middle = 0.5 * (low + high);
      (distance(middle) <= gap ? high : low) = middle;
    }
    draw.angle = high;
    return draw;
  }
  return draw;
}

}  // namespace meristem
