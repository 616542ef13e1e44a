// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace meristem {

/// Smooths measured values. Returns the values of the smoothest natural cubic spline whose weighted root mean square
/// distance from all `values` is at most `distance`. A distance of 0 leaves the values unchanged. If straight lines are
/// near enough, the result is the best straight lines.
///
/// `x` must be strictly ascending. `values` are one or more functions of x with x.size() values each, which share one
/// smoothness (the coordinates of a curve). `weights` must be above 0, or empty for equal weights. The result is the
/// values at `x`, to be joined by the natural spline. Throws std::invalid_argument if sizes differ, numbers are not
/// finite or `x` is not ascending. The cost is linear in points, some 7 passes.
std::vector<std::vector<double>> smooth_values(std::span<const double> x, std::vector<std::vector<double>> values,
                                               double distance, std::span<const double> weights = {});

}  // namespace meristem
