// SPDX-License-Identifier: Apache-2.0
// Places the attraction points in a crown.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/random.h"
#include "meristem/scene/crown/crown.h"
#include "meristem/scene/crown/crown_sampler.h"

namespace meristem {

/// The distribution of points in a crown.
struct PointDistribution {
  /// A part of the points, and the zone that they fill.
  struct Share {
    double share = 0;  ///< share of the points, in (0, 1]; the shares sum to at most 1
    CrownZone zone;    ///< the part of the crown that these points fill
  };
  std::uint64_t count = 0;    ///< number of points in all
  std::vector<Share> shares;  ///< the remaining points are uniform in the whole crown
  /// True: points keep the distance that their density allows; false: independent random points.
  bool blue_noise = false;
};

/// Returns the number of points of each share, followed by the number of remaining points. The numbers sum to
/// `distribution.count`.
std::vector<std::uint64_t> share_counts(const PointDistribution& distribution);

/// Returns the points relative to the root, share after share. The points of a share are uniform in volume. The result
/// does not depend on the number of threads. Throws InputError, at `crown_path` or `points_path`.shares[k], if the
/// crown or a zone is empty or nearly empty.
std::vector<Vec3> place_points(const Crown& crown, const PointDistribution& distribution, RandomKey key,
                               Progress& progress, const std::string& crown_path = "crown",
                               const std::string& points_path = "points");

/// Returns `count` points uniform in the crown's volume. The k-th point does not depend on `count`.
std::vector<Vec3> sample_crown(const Crown& crown, std::uint64_t count, RandomKey key, Progress& progress);

}  // namespace meristem
