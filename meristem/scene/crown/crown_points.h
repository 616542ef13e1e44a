// SPDX-License-Identifier: Apache-2.0
// The attraction points in a crown.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/scene/crown/crown.h"
#include "meristem/scene/crown/crown_sampler.h"

namespace meristem {

/// How points are spread over a crown.
struct PointDistribution {
  struct Share {
    double share = 0;  ///< share of the points, in (0, 1]; all shares together at most 1
    CrownZone zone;
  };
  std::uint64_t count = 0;
  std::vector<Share> shares;  ///< the rest is uniform in the whole crown
  bool blue_noise = false;    ///< neighbours keep the distance that their density allows, instead of falling at random
};

/// How many points each share gets, and at the end the rest: whole numbers that sum to the count.
std::vector<std::uint64_t> share_counts(const PointDistribution& distribution);

/// The points, relative to the root, share after share; within a share uniform in volume. They are equal on any number
/// of threads. Throws InputError where the crown or a zone is (nearly) empty, at `crown_path` or
/// `points_path`.shares[k].
std::vector<Vec3> place_points(const Crown& crown, const PointDistribution& distribution, RandomKey key,
                               Progress& progress, const std::string& crown_path = "crown",
                               const std::string& points_path = "points");

/// `count` points uniform in the crown's volume; the k-th does not depend on the count.
std::vector<Vec3> sample_crown(const Crown& crown, std::uint64_t count, RandomKey key, Progress& progress);

}  // namespace meristem
