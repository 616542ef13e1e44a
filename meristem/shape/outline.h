// SPDX-License-Identifier: Apache-2.0
// What a plant covers of a picture from far away: the outline that its levels of detail are judged by.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// How outlines are drawn.
struct OutlineOptions {
  int directions = 50;  ///< spread evenly over the half sphere, as from behind an outline is the same, mirrored
  int size = 128;       ///< pixels across the ball around the plant; raised, finer differences count
  int samples = 4;      ///< samples along each side of a pixel; raised, thin leaves are met more evenly
};

/// `count` unit directions, spread evenly over the upper half sphere.
std::vector<Vec3> outline_directions(int count);

/// How much of what two plants cover of a picture is common to both, from each direction.
struct OutlineOverlap {
  std::vector<double> of_direction;  ///< 0 to 1: what both cover over what any of them covers
  std::vector<double> growth;        ///< what the level covers over what the whole covers

  double least() const;        ///< overlap of the direction with the least overlap
  double mean() const;         ///< mean overlap of all directions
  double mean_growth() const;  ///< mean growth of all directions
};

/// Compares what `level` covers with what `whole` does, drawn by parallel rays from the same directions into the same
/// picture. A pixel counts by its covered share: the overlap is the sum of the lesser shares over the sum of the larger
/// ones. Holes of masked textures count as covered. Cost: 30 ns per triangle and direction. Throws
/// std::invalid_argument for options below 1, Cancelled.
OutlineOverlap outline_overlap(const MeshScene& whole, const MeshScene& level, const OutlineOptions& options,
                               Progress& progress);

}  // namespace meristem
