// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "meristem/base/image.h"

namespace meristem {

/// How a picture is written. Both are for JPEG files alone.
struct PictureFileOptions {
  std::optional<int> quality;              ///< 1 to 100; unset: kUsualJpegQuality
  std::optional<std::uint64_t> max_bytes;  ///< the quality is lowered until the file is no larger
};

/// Throws InputError unless `path` ends in .png, .jpg or .jpeg (or is "-", which is a PNG on standard output), and for
/// options that the format does not have. `transparent` pictures need PNG.
void check_picture_file(const std::string& path, bool transparent, const PictureFileOptions& options);

/// Writes a picture in the format of the path's ending; the file is there whole or not at all. The same picture gives
/// the same bytes. Throws MachineError, and what check_picture_file and encode_jpeg throw.
void write_picture(const Image& image, const std::string& path, const PictureFileOptions& options = {});

}  // namespace meristem
