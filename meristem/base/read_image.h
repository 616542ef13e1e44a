// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "meristem/base/image.h"
#include "meristem/base/limits.h"

namespace meristem {

/// Reads a picture from a PNG or JPEG file. The first bytes decide the format. 16-bit values are rounded to 8 bits, and
/// pictures without alpha become opaque. Throws InputError with the file for all other formats, for damaged files, and
/// for more pixels than limits.picture_pixels. Throws Cancelled soon after the ReadingStop of its thread was cancelled.
Image read_image(const std::string& path, const SizeLimits& limits);
/// Reads a picture from the bytes of a file, like `read_image`. `file` is the name of the file in messages.
Image parse_image(std::string_view bytes, const std::string& file, const SizeLimits& limits);

}  // namespace meristem
