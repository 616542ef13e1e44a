// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Returns the size of a scene of rays: the number of distinct triangles and frames. The frames of a placed plant count
/// once. RaySceneOptions::large_from is compared with this size.
std::uint64_t distinct_size(const MeshScene& scene);

/// Frees the tangents of all meshes, which large scenes of rays do not use. Meshes that are used elsewhere keep theirs
/// there. Takes the memory of one more mesh meanwhile.
void free_tangents(MeshScene& scene);

}  // namespace meristem
