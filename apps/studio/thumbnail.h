// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/image.h"
#include "meristem/base/limits.h"
#include "meristem/graph/table/value.h"

namespace meristem::studio {

/// {"picture": a PNG in base 64, "width", "height": of the whole picture} of a file that a document names, at most
/// `size` pixels along its longer side. `file` starts from the folder of `document`, and leads to nothing outside of
/// `root`. Throws InputError, MachineError.
Value thumbnail(const std::string& file, int size, const std::string& document, const std::string& root,
                const Limits& limits);

/// The picture in fewer pixels, each the mean of those that it stands for; as it is where it is small enough.
Image shrunk(const Image& image, int size);

}  // namespace meristem::studio
