// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/limits.h"
#include "meristem/scene/obstacle/closed_mesh.h"

namespace meristem {

/// Whether a file begins like a binary glTF.
bool begins_glb(std::string_view bytes);

/// All triangles that the default scene of a binary glTF 2.0 shows, where its nodes place them. Only what lies open in
/// the file itself is read: other files, sparse and compressed data, and instances by extensions are faults. `file` is
/// its name in messages. Throws InputError, before memory is spent on what a file only promises.
TriangleMesh parse_glb(std::string_view bytes, const std::string& file, const Limits& limits);

}  // namespace meristem
