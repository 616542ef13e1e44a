// SPDX-License-Identifier: Apache-2.0
// Computes tangents for normal maps from the directions of a mesh's uvs on its triangles.
#pragma once

#include <memory>

#include "meristem/base/mesh.h"
#include "meristem/plant/material.h"

namespace meristem {

/// Adds tangents to `mesh`. Vertices without triangles, or whose triangles have no area in uv, get an arbitrary
/// direction at right angles to their normal. A mesh without normals or uvs stays unchanged. Linear in vertices and
/// triangles.
void add_tangents(Mesh& mesh);

/// Returns true for materials whose texture has normals.
inline bool needs_tangents(const Material& material) {
  return material.texture != nullptr && material.texture->has_normals();
}

/// Returns the mesh as `material` needs it: a copy with tangents if they are missing, otherwise the mesh itself.
std::shared_ptr<const Mesh> with_needed_tangents(std::shared_ptr<const Mesh> mesh, const Material& material);

}  // namespace meristem
