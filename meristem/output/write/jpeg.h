// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "meristem/base/image.h"

namespace meristem {

/// The default quality of JPEG files: noise and thin twigs look as they do in a PNG.
inline constexpr int kUsualJpegQuality = 90;

/// Quality and size of a JPEG file.
struct JpegOptions {
  int quality = kUsualJpegQuality;         ///< 1 to 100; higher: closer to the picture, and larger
  std::optional<std::uint64_t> max_bytes;  ///< a larger file gets the highest quality at which it is no larger
};

/// The bytes of a JPEG file; the same picture and options give the same bytes. JPEG has no transparency: alpha is left
/// out. Throws InputError for a quality out of range and where even quality 1 has more than `max_bytes`; MachineError.
std::string encode_jpeg(const Image& image, const JpegOptions& options = {});

}  // namespace meristem
