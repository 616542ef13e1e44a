// SPDX-License-Identifier: Apache-2.0
// Levels of detail of plants of few triangles, such as low-poly trees.
#pragma once

#include <cstdint>

#include "meristem/base/progress.h"
#include "meristem/shape/detail.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// Plants with this number of triangles or fewer are simplified as a whole.
inline constexpr std::uint64_t kSmallPlant = 5000;

/// A level of detail of a plant whose level 0 is `whole`: points collapse, and small pieces go, in the order in which
/// the plant's outlines suffer least (outline_collapse.h), until the share of triangles is met or nothing can go any
/// more. Nothing reaches out of the whole's bounds. Faces that are shaded flat stay so. Begins a stage of `progress`.
MeshScene small_detail(const MeshScene& whole, const Detail& detail, Progress& progress);

}  // namespace meristem
