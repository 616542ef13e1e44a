// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/image.h"
#include "meristem/base/limits.h"
#include "meristem/graph/table/value.h"
#include "meristem/output/write/png.h"

namespace meristem::studio {

/// {"picture": a PNG in base 64, "width", "height": of the whole picture} of a file that a document names, at most
/// `size` pixels along its longer side. `file` starts from the folder of `document`, and leads to nothing outside of
/// `root`. Throws InputError, MachineError.
Value thumbnail(const std::string& file, int size, const std::string& document, const std::string& root,
                const Limits& limits);

/// The picture with at most `size` pixels along its longer side, each the mean of those that it stands for: of colours
/// that of their light, of `numbers` as they are. A picture that is small enough stays as it is.
Image shrunk(const Image& image, int size, PixelKind kind);

}  // namespace meristem::studio
