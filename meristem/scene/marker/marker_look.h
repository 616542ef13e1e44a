// SPDX-License-Identifier: Apache-2.0
// Finds the bricks of markers that each bud may see. Such a brick touches the bud's perception cone and has available
// markers. Buds are processed in the order of their bricks, so that consecutive buds read the same memory. Buds in
// bricks without available markers, the majority in an old crown, cost least.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/scene/marker/marker_bricks.h"
#include "meristem/scene/marker/marker_field.h"

namespace meristem {

/// A seeker that may see something.
struct Look {
  MarkerBricks::FinePosition position;
  Vec3 direction;    ///< unit vector
  float square;      ///< squared radius, voxels
  float slope;       ///< the cosine times its absolute value
  std::int32_t low;  ///< first and last layer of voxels along z that the cone touches
  std::int32_t high;
  std::uint32_t volume;
  std::uint32_t seeker;
  bool yields;
};

/// A brick whose markers a look may see.
struct Sighting {
  std::uint32_t slot;  ///< slot of the brick, which need not exist yet
  std::uint32_t look;
};

/// The looks and sightings of some of the seekers.
struct LookAround {
  std::vector<Look> looks;
  std::vector<Sighting> sightings;
};

/// Finds the looks and sightings of all seekers, and creates missing blocks. Returns nothing if there would be more
/// than `max_sightings` sightings; a little more memory may be used before this is known. Throws std::invalid_argument
/// for seekers out of range. Throws Cancelled.
std::optional<std::vector<LookAround>> look_around(MarkerBricks& bricks, std::span<const SpaceSeeker> seekers,
                                                   std::size_t volume_count, std::uint64_t max_sightings,
                                                   const Progress& progress);

}  // namespace meristem
