// SPDX-License-Identifier: Apache-2.0
// Compares the outlines of a plant and its levels of detail in small pictures.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Options for drawing outlines.
struct OutlineOptions {
  int directions = 50;  ///< spread evenly over the half sphere, because an outline seen from behind is a mirror image
  int size = 128;       ///< pixels across the ball around the plant; more show finer differences
  int samples = 4;      ///< samples along each side of a pixel; more sample thin leaves more evenly
};

/// Returns `count` unit directions, spread evenly over the upper half sphere.
std::vector<Vec3> outline_directions(int count);

/// The overlap of two plants in a picture, from each direction.
struct OutlineOverlap {
  std::vector<double> of_direction;  ///< 0 to 1: area that both cover divided by area that either covers
  std::vector<double> growth;        ///< area that the level covers divided by area that the whole covers

  double min() const;          ///< smallest overlap of all directions
  double mean() const;         ///< mean overlap of all directions
  double mean_growth() const;  ///< mean growth of all directions
};

/// Compares the areas that `level` and `whole` cover, drawn by parallel rays from equal directions into equal pictures.
/// A pixel counts by its covered share: the overlap is the sum of the smaller shares divided by the sum of the larger
/// ones. Holes of masked textures count as covered. The cost is 30 ns per triangle and direction. Throws
/// std::invalid_argument for options below 1, Cancelled.
OutlineOverlap outline_overlap(const MeshScene& whole, const MeshScene& level, const OutlineOptions& options,
                               Progress& progress);

}  // namespace meristem
