// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "meristem/document/document.h"

namespace meristem {

/// Returns a hash of the complete result of a document: the plant, its meshes with visible materials, the scene, the
/// camera of pictures, and the settings of files. Invisible parts are not included. Throws what growing throws.
std::uint64_t hash_of_result(const Document& document);

}  // namespace meristem
