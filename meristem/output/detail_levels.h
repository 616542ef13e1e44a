// SPDX-License-Identifier: Apache-2.0
// Which levels of detail of a plant are worth a file.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/document/grow.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// A level has at most this share of the triangles of the level before it, or it is none.
inline constexpr double kMostOfTheLevelBefore = 0.35;
/// What a level and the whole plant cover of a picture alike, from each of up to 26 sides, or the level is none: for
/// plants of at most kSmallPlant triangles, and for larger ones. Those are thinned out, and wherever the sky is seen
/// between leaves as small as a pixel, their crowns change from pixel to pixel.
inline constexpr double kLeastOutlineShared = 0.9;
/// Like kLeastOutlineShared, for plants of more than kSmallPlant triangles.
inline constexpr double kLeastCrownShared = 0.8;

/// How many pixels high a plant is shown at most as level `number`: half as many as the level before, 256 as a whole.
int pixels_of_level(int number);

/// Why `level`, the one of that `number`, which comes after a level of `before` triangles, is not worth a file: it has
/// hardly fewer triangles, or it would lose the plant's outline. Outlines are drawn from fewer sides, at least four,
/// where 26 would take more than a second. Empty for a level that is worth a file. Levels coarser than one that is not
/// are not worth one either.
std::string fault_of_level(const MeshScene& whole, std::uint64_t before, const MeshScene& level, int number,
                           Progress& progress);

/// A level of detail that is not worth a file, and why.
struct WorthlessLevel {
  int number = 0;      ///< number of the level, from 1
  std::string reason;  ///< why the level is not worth a file
};

/// Makes the levels of detail 1 to `count` of a plant one after the other, and gives the number and the meshes of each
/// to `take`. Ends before the first level that is not worth a file, and returns that level. `whole` are the plant's
/// meshes in full detail, with their textures.
std::optional<WorthlessLevel> make_levels(const Document& document, const Plant& plant, const MeshScene& whole,
                                          int count, const std::function<void(int, MeshScene)>& take,
                                          Progress& progress);

}  // namespace meristem
