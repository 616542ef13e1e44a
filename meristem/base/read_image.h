// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/image.h"
#include "meristem/base/limits.h"

namespace meristem {

/// A picture from a PNG or JPEG file, told apart by their first bytes; 16-bit values are rounded to 8, and what has no
/// alpha is opaque. Throws InputError with the file for anything else, for damaged files, and for more pixels than
/// limits.picture_pixels.
Image read_image(const std::string& path, const Limits& limits);
/// A picture from a file's bytes, as `read_image` gives it; `file` is the file's name in messages.
Image parse_image(std::string_view bytes, const std::string& file, const Limits& limits);

}  // namespace meristem
