// SPDX-License-Identifier: Apache-2.0
// Measures branching angles, area ratios and pipe exponents at the forks of a skeleton. The exponent n of the pipe
// model r^n = sum of r_i^n is found by bisection, since the sum falls as n grows.
#include "meristem/measure/forks.h"

#include <algorithm>

#include "meristem/base/math.h"

namespace meristem {
namespace {

constexpr double kLargestExponent = 100;
constexpr int kHalvings = 50;  // reaches an exponent exactly to 1e-13

DVec3 segment(const Skeleton& skeleton, NodeIndex node) {
  return DVec3(skeleton.position[node]) - DVec3(skeleton.position[skeleton.parent[node]]);
}

/// Returns nothing for vectors without length.
std::optional<double> angle_between(DVec3 a, DVec3 b) {
  const double lengths = glm::length(a) * glm::length(b);
  if (!(lengths > 0)) return {};
  // The two-argument form is exact near 0 and 180°, where the arc cosine loses half the digits.
  return math::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

void sample_angles(const Skeleton& skeleton, NodeIndex fork, std::span<const NodeIndex> children,
                   std::vector<double>& angles) {
  if (skeleton.is_root(fork)) return;
  const DVec3 parent = segment(skeleton, fork);
  for (const NodeIndex child : children) {
    if (skeleton.axis[child] == skeleton.axis[fork]) continue;
    if (const auto angle = angle_between(parent, segment(skeleton, child))) angles.push_back(*angle);
  }
}

}  // namespace

void ForkSamples::append(const ForkSamples& other) {
  const auto add = [](std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  add(branching_angles, other.branching_angles);
  add(area_ratios, other.area_ratios);
  add(pipe_exponents, other.pipe_exponents);
  pipe_unsolved += other.pipe_unsolved;
}

ForkSamples sample_forks(const Skeleton& skeleton, const NodeChildren& children, double fork_diameter) {
  ForkSamples samples;
  std::vector<double> radii;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const auto of_node = children.of(node);
    if (!of_node.empty()) sample_angles(skeleton, node, of_node, samples.branching_angles);
    if (of_node.size() < 2) continue;
    const double radius = skeleton.radius[node];
    radii.clear();
    double squares = 0;
    for (const NodeIndex child : of_node) {
      radii.push_back(skeleton.radius[child]);
      squares += radii.back() * radii.back();
    }
    if (!(radius > 0) || !(*std::min_element(radii.begin(), radii.end()) > 0)) continue;
    // Radii are 32-bit floats. Compare as floats, so that a diameter that was written as 0.02 m does not fail by its
    // last bit.
    if (static_cast<float>(2 * radius) >= static_cast<float>(fork_diameter)) {
      samples.area_ratios.push_back(squares / (radius * radius));
    }
    if (const auto exponent = pipe_exponent(radius, radii)) {
      samples.pipe_exponents.push_back(*exponent);
    } else {
      ++samples.pipe_unsolved;
    }
  }
  return samples;
}

std::optional<double> pipe_exponent(double parent_radius, std::span<const double> child_radii) {
  const auto excess = [&](double exponent) {
    double sum = -1;
    for (const double radius : child_radii) sum += math::pow(radius / parent_radius, exponent);
    return sum;
  };
  // The sum falls as the exponent grows if all children are thinner than the parent. At exponent 0 the sum is the
  // number of children.
  const bool all_thinner =
      std::all_of(child_radii.begin(), child_radii.end(), [&](double radius) { return radius < parent_radius; });
  if (!all_thinner || child_radii.size() < 2 || excess(kLargestExponent) > 0) return {};
  double low = 0;
  double high = kLargestExponent;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = (low + high) / 2;
    (excess(middle) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace meristem
