// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Returns the number of distinct triangles and of frames, by which a scene of rays is large
/// (RaySceneOptions::large_from). The frames of a placed plant count once.
std::uint64_t distinct_size(const MeshScene& scene);

/// Frees the tangents of all meshes, which large scenes of rays do not use. Meshes that are used elsewhere keep theirs
/// there. Takes the memory of one more mesh meanwhile.
void free_tangents(MeshScene& scene);

}  // namespace meristem
