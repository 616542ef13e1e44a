// SPDX-License-Identifier: Apache-2.0
// Blades over time. A blade whose proportions change can be cut into different triangles, but it is still one blade.
#pragma once

#include <optional>

#include "meristem/base/mesh.h"

namespace meristem {

/// Returns the vertices of `model`, moved to the corresponding positions on `blade`: the positions with equal uvs. The
/// result has no triangles. Returns nothing if a mesh has no uvs, covers parts of the picture twice, or if the stalks
/// differ.
std::optional<Mesh> as_model_is_cut(const Mesh& blade, const Mesh& model);

}  // namespace meristem
