// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "meristem/document/document.h"

namespace meristem {

/// Hash of all that a document comes to: what has grown, its meshes with the materials that they show, the scene and
/// the camera of pictures, and the settings of files. What nothing shows is not in it. Throws what growing throws.
std::uint64_t hash_of_result(const Document& document);

}  // namespace meristem
