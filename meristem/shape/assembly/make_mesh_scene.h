// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/cache.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail/detail.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Makes the meshes of a plant. Every stem gets its surface (blended bodies and crowns: stem/body_meshes.h), and every
/// prototype its instances, in the order of the plant's organs. `detail` sets the coarseness (detail/detail.h). With a
/// `cache`, stems that were meshed before keep their meshes (stem/cached_meshes.h). Begins a stage of `progress`, which
/// counts nodes and organs, after the stages of bodies. Throws InputError before memory is used if limits on triangles
/// or geometry would be exceeded. The error names the largest component. Throws Cancelled, and std::invalid_argument
/// for invalid indices and details out of range.
MeshScene make_mesh_scene(const Plant& plant, const SizeLimits& limits, Progress& progress,
                          const MeshDetail& detail = {}, Cache* cache = nullptr);

/// Makes equal meshes and frees the plant meanwhile: first its own stems and organs, then each variant without other
/// owners. Stands of many different plants therefore take less memory.
MeshScene make_mesh_scene(Plant&& plant, const SizeLimits& limits, Progress& progress, const MeshDetail& detail = {});

}  // namespace meristem
