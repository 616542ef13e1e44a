// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/limits.h"
#include "meristem/output/picture/picture.h"

namespace meristem {

/// 16 hexadecimal digits that tell whether a picture would look as an earlier one did: a hash of all that take_picture
/// would draw (meshes, materials, textures, scene, view, size, samples), at a small part of the cost of drawing it.
/// Equal for equal pictures of one version of the program on one kind of machine.
std::string picture_fingerprint(const GrownDocument& grown, const Limits& limits, const Scene& scene,
                                const PictureOptions& options);

}  // namespace meristem
