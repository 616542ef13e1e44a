// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "meristem/base/image.h"

namespace meristem {

/// Options of picture files. Both are valid only for JPEG files.
struct PictureFileOptions {
  std::optional<int> quality;              ///< 1 to 100; unset: kUsualJpegQuality
  std::optional<std::uint64_t> max_bytes;  ///< maximum size; the quality is lowered until the file fits
};

/// Throws InputError unless `path` ends in .png, .jpg or .jpeg (or is "-", a PNG on standard output), and for options
/// that the format does not have. `transparent` pictures need PNG.
void check_picture_file(const std::string& path, bool transparent, const PictureFileOptions& options);

/// Writes a picture in the format of the path's ending. The file appears whole or not at all. Equal pictures give equal
/// bytes. Throws MachineError, and like check_picture_file and encode_jpeg.
void write_picture(const Image& image, const std::string& path, const PictureFileOptions& options = {});

}  // namespace meristem
