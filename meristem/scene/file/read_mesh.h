// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/limits.h"
#include "meristem/scene/obstacle/closed_mesh.h"

namespace meristem {

/// The triangles of an OBJ, PLY or binary glTF (GLB) file; larger polygons become fans. Materials, normals and texture
/// coordinates are passed over. Throws InputError with file and line, row or path.
TriangleMesh read_mesh(const std::string& path, const Limits& limits);
/// The triangles of a file's bytes, as `read_mesh` gives them; `file` is the file's name in messages.
TriangleMesh parse_mesh(std::string_view bytes, const std::string& file, const Limits& limits);

/// A closed mesh from a file; throws InputError that says where it is not closed.
ClosedMesh read_closed_mesh(const std::string& path, const Limits& limits);

}  // namespace meristem
