// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// One number for each fork or lateral that has it, in the order of the nodes.
struct ForkSamples {
  /// Radians between the parent's segment that ends at the fork and the lateral's first one. Laterals on a root, and
  /// those with a segment of no length, have none.
  std::vector<double> branching_angles;
  /// The children's cross-sections over the parent's.
  std::vector<double> area_ratios;
  /// See `pipe_exponent`.
  std::vector<double> pipe_exponents;
  std::uint64_t pipe_unsolved = 0;  ///< forks without a pipe exponent

  /// Adds another skeleton's.
  void append(const ForkSamples& other);
};

/// `fork_diameter` (metres): area ratios count from parents at least that thick. Forks with a radius of 0 count
/// nowhere.
ForkSamples sample_forks(const Skeleton& skeleton, const Children& children, double fork_diameter);

/// The n with r^n = sum of r_i^n, by bisection; none where a child is as thick as its parent (then no n fits, or the
/// others have radius 0), or where it is above 100. Radii are above 0.
std::optional<double> pipe_exponent(double parent_radius, std::span<const double> child_radii);

}  // namespace meristem
