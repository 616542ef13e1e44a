// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Measures of forks and laterals. Each list has one number for each fork or lateral that has the measure, in the order
/// of the nodes.
struct ForkSamples {
  /// Angles in radians between the parent's segment that ends at the fork and the first segment of the lateral.
  /// Laterals on a root and laterals with a segment of no length have no angle.
  std::vector<double> branching_angles;
  /// Sum of the children's cross-sections divided by the parent's cross-section.
  std::vector<double> area_ratios;
  /// Exponents from `pipe_exponent`.
  std::vector<double> pipe_exponents;
  std::uint64_t pipe_unsolved = 0;  ///< forks without a pipe exponent

  /// Appends the samples of another skeleton.
  void append(const ForkSamples& other);
};

/// Measures the forks and laterals of a skeleton. `fork_diameter` (metres): only forks whose parent is at least this
/// thick have an area ratio. Forks where the parent or a child has a radius of 0 have only their angles, and do not
/// count in `pipe_unsolved`.
ForkSamples sample_forks(const Skeleton& skeleton, const NodeChildren& children, double fork_diameter);

/// Returns the exponent n with r^n = sum of r_i^n, found by bisection. Returns nothing if there are fewer than two
/// children, or if a child is at least as thick as its parent, because then no n exists. Returns nothing if n is above
/// 100. Radii must be above 0.
std::optional<double> pipe_exponent(double parent_radius, std::span<const double> child_radii);

}  // namespace meristem
