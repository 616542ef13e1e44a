// SPDX-License-Identifier: Apache-2.0
// Which bricks of markers each bud may see: those that touch its perception cone and have markers to be had there. Buds
// are taken by the bricks that they are in, so that those that follow each other look at the same memory; the many amid
// full bricks in an old crown cost the least.
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
  Vec3 direction;    ///< unit
  float square;      ///< of the radius, voxels
  float slope;       ///< the cosine times its absolute value
  std::int32_t low;  ///< first and last layer of voxels along z that the cone touches
  std::int32_t high;
  std::uint32_t volume;
  std::uint32_t seeker;
  bool yields;
};

/// That a look may see markers of a brick.
struct Sighting {
  std::uint32_t slot;  ///< of the brick, which need not be there yet
  std::uint32_t look;
};

/// What some of the seekers may see.
struct LookAround {
  std::vector<Look> looks;
  std::vector<Sighting> sightings;
};

/// Adds blocks to the bricks where there is none yet. Nothing where the seekers would see bricks more than
/// `most_sightings` times, a little memory beyond which may be spent. Throws std::invalid_argument for seekers out of
/// range, and Cancelled.
std::optional<std::vector<LookAround>> look_around(MarkerBricks& bricks, std::span<const Seeker> seekers,
                                                   std::size_t volume_count, std::uint64_t most_sightings,
                                                   const Progress& progress);

}  // namespace meristem
