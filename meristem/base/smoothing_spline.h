// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace meristem {

/// Values that vary smoothly through measured ones: the smoothest natural cubic spline whose weighted root mean square
/// distance from all `values` is at most `distance`. 0 leaves the values as they are; where even straight lines come
/// that near, the best straight lines come out.
///
/// `x` rises strictly; `values` are one or more functions of it, of x.size() values each, that share one smoothness
/// (the coordinates of a curve). `weights` are above 0, or empty for equal ones. Gives the values at `x`; the natural
/// spline through them is the one meant. Throws std::invalid_argument for sizes that differ, numbers that are not
/// finite, `x` that does not rise. Cost is linear in points, some 7 passes.
std::vector<std::vector<double>> smooth_values(std::span<const double> x, std::vector<std::vector<double>> values,
                                               double distance, std::span<const double> weights = {});

}  // namespace meristem
