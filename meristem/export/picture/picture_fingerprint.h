// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/limits.h"
#include "meristem/export/picture/picture.h"

namespace meristem {

/// Returns 16 hexadecimal digits that are equal if two pictures would look equal. They are a hash of everything that
/// take_picture would draw (meshes, materials, textures, scene, view, size, samples), at a small part of the cost of
/// drawing. Comparable within one version of the program on one kind of machine.
std::string picture_fingerprint(const GrownDocument& grown, const SizeLimits& limits, const Scene& scene,
                                const PictureOptions& options);

}  // namespace meristem
