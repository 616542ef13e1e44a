// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace meristem {

/// An 8-bit picture with alpha, rows from top to bottom, sRGB, alpha not premultiplied.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 bytes a pixel
};

/// Writes a PNG to `path` ("-" for standard output); same picture, same bytes. Throws MachineError.
void write_png(const Image& image, const std::string& path);

}  // namespace meristem
