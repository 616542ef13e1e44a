// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The part of a crown's hull that the sun lights, as shares of the hull's area in [0, 1].
struct CrownLight {
  std::vector<double> lit_shares;  ///< lit share at each of the sun's positions
  double lit_share = 0;            ///< plain mean of the shares; 0 if the sun never rises
};

/// Number of rays for a crown's lit share, over all positions of the sun together. More rays give finer shadow edges
/// and take longer. Evenly spread rays leave an error of about 0.01 points (hundredths of the hull, measured among ten
/// boxes). Random rays would leave a standard error of up to 0.16 points.
inline constexpr std::uint64_t kCrownRays = 100'000;

/// Computes the lit share of `hull`, which must be closed, convex and face outward, as convex_hull returns it. A
/// position on the hull is lit if its face looks toward the sun and no obstacle stands between. Without obstacles, the
/// shares are exact and cost no rays. The result is equal on any number of threads. Throws Cancelled if `progress` is
/// given and was cancelled.
CrownLight measure_crown_light(const Mesh& hull, const Scene& scene, std::uint64_t rays = kCrownRays,
                               const Progress* progress = nullptr);

}  // namespace meristem
