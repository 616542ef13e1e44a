// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Which points are left, by rising index, when `share` (0 to 1) of all, rounded down, is removed, the darkest first;
/// among equally dark points the lot decides.
std::vector<std::uint32_t> brightest(std::span<const double> light, double share);

/// The light of each of `points` (world space), 0 to 1 without lamps: over the scene's lights, weighted by strength,
/// the mean of exp(-k c), 0 in the shade of obstacles, with c the number of other points between it and the light and
/// within `radius` of that way. Points do not dim lamps. c is counted in cells of a sixth of the radius. Costs in
/// proportion to points and lights; the same on any number of threads. Throws Cancelled.
std::vector<double> light_of_points(const std::vector<Vec3>& points, const Scene& scene, double radius, double k,
                                    const Progress& progress);

}  // namespace meristem
