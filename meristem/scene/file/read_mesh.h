// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/limits.h"
#include "meristem/scene/obstacle/closed_mesh.h"

namespace meristem {

/// Returns the triangles of an OBJ, PLY or binary glTF (GLB) file. Polygons with more corners become fans. Ignores
/// materials, normals and texture coordinates. Throws InputError with file and line, row or path.
TriangleMesh read_mesh(const std::string& path, const SizeLimits& limits);
/// Like read_mesh(), for the bytes of a file. `file` is the file's name in messages.
TriangleMesh parse_mesh(std::string_view bytes, const std::string& file, const SizeLimits& limits);

/// Returns the closed mesh in a file. Throws InputError with the place where the mesh is not closed.
ClosedMesh read_closed_mesh(const std::string& path, const SizeLimits& limits);

}  // namespace meristem
