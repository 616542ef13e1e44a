// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/limits.h"
#include "meristem/scene/obstacle/closed_mesh.h"

namespace meristem {

/// Returns true if the bytes begin like a binary glTF file.
bool begins_glb(std::string_view bytes);

/// Returns all triangles that the default scene of a binary glTF 2.0 file shows, placed by its nodes. Reads only
/// uncompressed data within the file. References to other files, sparse or compressed data, and instances by extensions
/// are errors. `file` is the name in messages. Throws InputError before allocating memory for data that the file does
/// not contain.
TriangleMesh parse_glb(std::string_view bytes, const std::string& file, const SizeLimits& limits);

}  // namespace meristem
