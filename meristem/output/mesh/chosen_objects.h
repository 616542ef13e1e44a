// SPDX-License-Identifier: Apache-2.0
// Chooses the objects of a mesh scene that are written or drawn, such as a trunk without its crown.
#pragma once

#include <span>
#include <string>

#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Returns the meshes of `scene` whose objects (object_name) are in `names`; without names, all meshes. Throws
/// InputError with the known objects for a name that no mesh has. The error begins with `option`.
MeshScene chosen_objects(const MeshScene& scene, std::span<const std::string> names, const std::string& option);

}  // namespace meristem
