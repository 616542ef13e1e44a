// SPDX-License-Identifier: Apache-2.0
// Writes the JSON chunk of a binary glTF.
#pragma once

#include <string_view>

#include "meristem/base/function_ref.h"
#include "meristem/base/progress.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/gltf/gltf_layout.h"

namespace meristem {

/// Passes the JSON for `layout` to `sink` in pieces. The pieces are equal in every call. Memory does not grow with the
/// instances. Throws Cancelled.
void emit_gltf_json(const GltfLayout& layout, const std::vector<Material>& materials, const Provenance& provenance,
                    FunctionRef<void(std::string_view)> sink, Progress& progress);

}  // namespace meristem
