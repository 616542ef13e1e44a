// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "meristem/base/image.h"

namespace meristem {

/// The default quality of JPEG files, at which noise and thin twigs look as in a PNG.
inline constexpr int kUsualJpegQuality = 90;

/// Quality and size of a JPEG file.
struct JpegOptions {
  int quality = kUsualJpegQuality;         ///< 1 to 100; higher values are closer to the picture and give larger files
  std::optional<std::uint64_t> max_bytes;  ///< maximum file size; a larger file is encoded again at the highest quality
                                           ///< that fits
};

/// Returns the bytes of a JPEG file. Equal pictures and options give equal bytes. JPEG has no transparency, so alpha is
/// left out. Throws InputError for a quality out of range, and if even quality 1 needs more than `max_bytes`. Throws
/// MachineError.
std::string encode_jpeg(const Image& image, const JpegOptions& options = {});

}  // namespace meristem
