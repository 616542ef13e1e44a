// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Returns the indices of the points that remain, in rising order, if the darkest `share` (0 to 1) of the points is
/// removed. The number is rounded down. Ties are broken at random.
std::vector<std::uint32_t> brightest(std::span<const double> light, double share);

/// Returns the light of each of `points` (world space), 0 to 1 without lamps. The light is the mean of exp(-k c) over
/// the scene's lights, weighted by strength; it is 0 in the shade of obstacles. c is the number of other points between
/// the point and the light, within `radius` of the ray. Points do not dim lamps. c is counted in cells of a sixth of
/// the radius. Cost: proportional to points times lights. The result does not depend on the number of threads. Throws
/// Cancelled.
std::vector<double> light_of_points(const std::vector<Vec3>& points, const Scene& scene, double radius, double k,
                                    const Progress& progress);

}  // namespace meristem
