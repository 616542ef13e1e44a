// SPDX-License-Identifier: Apache-2.0
// Tangents for normal maps, from the way a mesh's uvs run over its triangles.
#pragma once

#include <memory>

#include "meristem/base/mesh.h"
#include "meristem/plant/material.h"

namespace meristem {

/// Gives `mesh` its tangents. Vertices whose triangles have no area on the picture, or none at all, get some direction
/// at right angles to their normal. A mesh without normals or uvs stays as it is. Linear in vertices and triangles.
void add_tangents(Mesh& mesh);

/// True for materials whose texture has normals.
inline bool needs_tangents(const Material& material) {
  return material.texture != nullptr && material.texture->has_normals();
}

/// The mesh as `material` needs it: with tangents, in a copy, where they are missing; else the same one.
std::shared_ptr<const Mesh> with_needed_tangents(std::shared_ptr<const Mesh> mesh, const Material& material);

}  // namespace meristem
