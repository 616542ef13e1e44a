// SPDX-License-Identifier: Apache-2.0
// Fuzzes pictures: either a picture with the bytes for its size and no more pixels than allowed, or an error of this
// file.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "meristem/base/diagnostic.h"
#include "meristem/base/read_image.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meristem;
  SizeLimits limits;
  limits.picture_pixels = 10'000;
  try {
    const Image image = parse_image({reinterpret_cast<const char*>(data), size}, "picture", limits);
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    require(!image.is_empty() && pixels <= limits.picture_pixels && image.rgba.size() == 4 * pixels);
  } catch (const InputError& error) {
    require_errors_of(error, "picture");
  }
  return 0;
}
