// SPDX-License-Identifier: Apache-2.0
// Decoders of single picture formats. read_image.h chooses among them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "meristem/base/image.h"
#include "meristem/base/limits.h"

namespace meristem {

/// Returns the pixels of a PNG in sRGB with 8 bits, with their alpha. Checks the ReadingStop after each row. Throws
/// InputError if the bytes are damaged or the picture is too large, MachineError (memory), Cancelled.
Image parse_png(std::string_view bytes, const std::string& file, const SizeLimits& limits);

/// Returns the opaque pixels of a JPEG. Checks the ReadingStop after each row, and after each row of blocks of a
/// progressive JPEG. Throws like parse_png.
Image parse_jpeg(std::string_view bytes, const std::string& file, const SizeLimits& limits);

/// Returns a picture of that size with all bytes zero. Throws InputError if it is too large.
Image empty_image(std::uint64_t width, std::uint64_t height, const std::string& file, const SizeLimits& limits);

/// Throws InputError for a picture of `kind` ("PNG") that cannot be decoded.
[[noreturn]] void throw_damaged(const std::string& file, std::string_view kind, std::string_view reason);

}  // namespace meristem
