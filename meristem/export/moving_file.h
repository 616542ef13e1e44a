// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/output/write/encoded_pictures.h"
#include "meristem/shape/moving/moving_scene.h"

namespace meristem {

/// Throws InputError if the format of the file's ending cannot store an animation (FileFormat::can_animate), and for
/// standard output. Call this before growth.
void check_moving_file(const std::string& path);

/// Writes a document's animation, the result of grow_moving, to a file in a format that can store animations.
/// `pictures` are shared with other files, or null. Throws like check_moving_file and the format's writer,
/// MachineError, Cancelled.
void write_moving_file(const Document& document, const MovingScene& moving, const std::string& path, Progress& progress,
                       EncodedPictures* pictures = nullptr);

}  // namespace meristem
