// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/output/write/encoded_pictures.h"
#include "meristem/shape/moving/moving_scene.h"

namespace meristem {

/// Writes a document's animation, as grow_moving gives it, to a file in a format that can hold it
/// (Format::can_animate). `pictures` are shared with other files; null: none. Throws InputError for other endings and
/// as the format's writer does, MachineError, Cancelled.
void write_moving_file(const Document& document, const MovingScene& moving, const std::string& path, Progress& progress,
                       EncodedPictures* pictures = nullptr);

}  // namespace meristem
