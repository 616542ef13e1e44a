// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/progress.h"
#include "meristem/document/document.h"
#include "meristem/output/write/encoded_pictures.h"
#include "meristem/shape/moving/moving_scene.h"

namespace meristem {

/// Throws InputError where a file's ending is of no format that can hold an animation (Format::can_animate), and for
/// standard output; to be asked before anything is grown for it.
void check_moving_file(const std::string& path);

/// Writes a document's animation, as grow_moving gives it, to a file in a format that can hold it.
/// `pictures` are shared with other files; null: none. Throws as check_moving_file and the format's writer do,
/// MachineError, Cancelled.
void write_moving_file(const Document& document, const MovingScene& moving, const std::string& path, Progress& progress,
                       EncodedPictures* pictures = nullptr);

}  // namespace meristem
