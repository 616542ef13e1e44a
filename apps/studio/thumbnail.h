// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/image.h"
#include "meristem/base/limits.h"
#include "meristem/graph/table/value.h"
#include "meristem/output/write/png.h"

namespace meristem::studio {

/// Returns {"picture": a PNG in base 64, "width", "height": of the whole picture} for a file that a document names, at
/// most `size` pixels along its longer side. `file` is relative to the folder of `document`, and must lie within
/// `root`. Throws InputError, MachineError.
Value thumbnail(const std::string& file, int size, const std::string& document, const std::string& root,
                const SizeLimits& limits);

/// Returns the picture with at most `size` pixels along its longer side. Each pixel is the mean of the pixels that it
/// covers: the mean of light for colours, and the mean of the numbers for `numbers`. A picture that is small enough is
/// not changed.
Image shrunk(const Image& image, int size, PixelKind kind);

}  // namespace meristem::studio
