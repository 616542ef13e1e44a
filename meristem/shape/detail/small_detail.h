// SPDX-License-Identifier: Apache-2.0
// Levels of detail of plants with few triangles, such as low-poly trees.
#pragma once

#include <cstdint>

#include "meristem/base/progress.h"
#include "meristem/shape/detail/detail.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Plants with at most this number of triangles are simplified as a whole.
inline constexpr std::uint64_t kSmallPlant = 5000;

/// Returns a level of detail of a plant whose level 0 is `whole`. Points collapse and small pieces are removed in the
/// order in which the plant's outlines suffer least (outline/outline_collapse.h). This ends when the share of triangles
/// is reached, or when nothing more can be removed. The result stays within the bounds of `whole`. Flat-shaded faces
/// stay flat-shaded. Begins a stage of `progress`.
MeshScene small_detail(const MeshScene& whole, const MeshDetail& detail, Progress& progress);

}  // namespace meristem
