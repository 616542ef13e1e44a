// SPDX-License-Identifier: Apache-2.0
// Blades over time: one whose proportions change may be cut into other triangles, and is the same blade nevertheless.
#pragma once

#include <optional>

#include "meristem/base/mesh.h"

namespace meristem {

/// The vertices that `model` has, where they lie on `blade`: at the same places of the picture that both carry. Without
/// triangles. Nothing where a mesh has no uvs, covers places of the picture twice, or where stalks differ.
std::optional<Mesh> as_model_is_cut(const Mesh& blade, const Mesh& model);

}  // namespace meristem
