// SPDX-License-Identifier: Apache-2.0
// Chooses the decoder of a picture by its first bytes. The size is checked against the limit before memory for the
// pixels is allocated.
#include "meristem/base/read_image.h"

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/image_readers.h"
#include "meristem/base/read_file.h"

namespace meristem {

namespace {

constexpr std::string_view kPngStart = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kJpegStart = "\xff\xd8\xff";

[[noreturn]] void throw_image_error(const std::string& file, std::string message, std::string expected) {
  throw InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected), .file = file});
}

}  // namespace

void throw_damaged(const std::string& file, std::string_view kind, std::string_view reason) {
  throw_image_error(file, fmt::format("the {} is damaged: {}", kind, reason), "a picture that other programs can open");
}

Image empty_image(std::uint64_t width, std::uint64_t height, const std::string& file, const SizeLimits& limits) {
  if (width * height > limits.picture_pixels) {
    Diagnostic diagnostic = limit_diagnostic("pixels of a picture", static_cast<double>(width * height),
                                             limits.picture_pixels, "picture_pixels", "");
    diagnostic.file = file;
    throw InputError(std::move(diagnostic));
  }
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  image.rgba.resize(std::size_t{4} * width * height);
  return image;
}

Image parse_image(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  if (bytes.substr(0, kPngStart.size()) == kPngStart) return parse_png(bytes, file, limits);
  if (bytes.substr(0, kJpegStart.size()) == kJpegStart) return parse_jpeg(bytes, file, limits);
  throw_image_error(file, "this picture cannot be read", "a PNG or a JPEG file");
}

Image read_image(const std::string& path, const SizeLimits& limits) {
  return parse_image(read_file(path, limits.file_bytes), path, limits);
}

}  // namespace meristem
