// SPDX-License-Identifier: Apache-2.0
// Which bricks of markers each bud may see: those that touch its perception cone and may have a free marker. Buds
// amid full bricks, the most in an old crown, cost a few lookups of blocks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/scene/marker_bricks.h"
#include "meristem/scene/marker_field.h"

namespace meristem {

/// A seeker that may see something.
struct Look {
  MarkerBricks::FinePlace place;
  Vec3 direction;  ///< unit
  float square;    ///< of the radius, voxels
  float slope;     ///< the cosine times its absolute value
  std::uint32_t volume;
  std::uint32_t seeker;

  /// Whether it sees a marker at the end of `way`, in voxels, whose squared length is given.
  bool reaches(Vec3 way, float squared) const {
    const float along = glm::dot(direction, way);
    return squared <= square && along * std::abs(along) >= slope * squared;
  }
};

/// That a look may see markers of a brick.
struct Sighting {
  std::uint32_t slot;  ///< of the brick, which need not be there yet
  std::uint32_t look;
};

/// What some seekers that follow each other may see, in their order: so are the sightings of every one slot.
struct LookAround {
  std::vector<Look> looks;
  std::vector<Sighting> sightings;
};

/// Adds blocks to the bricks where there is none yet. Throws std::invalid_argument for seekers out of range, and
/// Cancelled.
std::vector<LookAround> look_around(MarkerBricks& bricks, std::span<const Seeker> seekers, std::size_t volume_count,
                                    const Progress& progress);

}  // namespace meristem
