// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Returns the meshes that make_mesh_scene makes of a plant at level 0, without the attributes that rays do not need.
/// Tubes have no normals and tangents, and have uvs only under textures with holes. Instances have no tints. Takes
/// about half of the memory. Textures with holes must be painted before. Throws like make_mesh_scene.
MeshScene make_ray_meshes(const Plant& plant, const SizeLimits& limits, Progress& progress);

/// Makes equal meshes and frees the plant meanwhile, like make_mesh_scene.
MeshScene make_ray_meshes(Plant&& plant, const SizeLimits& limits, Progress& progress);

}  // namespace meristem
