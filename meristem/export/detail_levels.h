// SPDX-License-Identifier: Apache-2.0
// Decides which levels of detail of a plant are worth a file.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/document/grow.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Maximum number of triangles of a level, as a share of the level before. A level with more triangles is not written.
inline constexpr double kMostOfTheLevelBefore = 0.35;
/// Minimum share of its outline that a level must have in common with the whole plant, from each of up to 26 sides. For
/// plants of at most kSmallPlant triangles. Larger plants are thinned out, and gaps between leaves as small as a pixel
/// change their outline.
inline constexpr double kMinOutlineShared = 0.9;
/// Like kMinOutlineShared, for plants of more than kSmallPlant triangles.
inline constexpr double kMinCrownShared = 0.8;

/// Returns the maximum height of a plant that is shown as level `number`, in pixels: half of the level before, 256 for
/// level 0, but at least 16.
int pixels_of_level(int number);

/// Returns why `level` is not worth a file: it has hardly fewer triangles than the level before, or it loses the
/// plant's outline. Returns an empty text for a level that is worth a file. `number` is the number of the level, and
/// `before` the number of triangles of the level before. Outlines are drawn from fewer than 26 sides, but at least
/// four, if 26 would take more than a second. If a level is not worth a file, no coarser level is.
std::string error_of_level(const MeshScene& whole, std::uint64_t before, const MeshScene& level, int number,
                           Progress& progress);

/// A level of detail that is not worth a file, and why.
struct WorthlessLevel {
  int number = 0;      ///< number of the level, from 1
  std::string reason;  ///< why the level is not worth a file
};

/// Makes the levels of detail 1 to `count` of a plant in order, and passes the number and the meshes of each to `take`.
/// Stops before the first level that is not worth a file and returns this level. Returns nothing if all levels are
/// worth a file. `whole` must be the plant's meshes in full detail, with their textures. Throws like mesh_detail.
std::optional<WorthlessLevel> make_levels(const Document& document, const Plant& plant, const MeshScene& whole,
                                          int count, const std::function<void(int, MeshScene)>& take,
                                          Progress& progress);

}  // namespace meristem
