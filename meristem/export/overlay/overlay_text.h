// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "meristem/base/function_ref.h"
#include "meristem/base/image.h"
#include "meristem/export/overlay/overlay.h"

namespace meristem {

/// Returns the position on the film, from -1 to 1, x to the right and y upward. Returns nothing for a position behind
/// the camera.
using OnFilm = FunctionRef<std::optional<Vec2>(Vec3 position)>;

/// Writes the labels of overlays into a picture, and their legend into the upper left corner. Letters are dark with a
/// light rim, and their height suits the picture.
void write_overlay_text(Image& image, std::span<const OverlayLayer> layers, OnFilm on_film);

}  // namespace meristem
