// SPDX-License-Identifier: Apache-2.0
// Decodes PNG with libpng's simplified interface and JPEG with libjpeg-turbo. The size is checked against the limit
// before memory for the pixels is allocated.
#include "meristem/base/read_image.h"

#include <memory>

#include <fmt/format.h>
#include <png.h>
#include <turbojpeg.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/read_file.h"

namespace meristem {

namespace {

constexpr std::string_view kPngStart = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kJpegStart = "\xff\xd8\xff";

[[noreturn]] void throw_image_error(const std::string& file, std::string message, std::string expected) {
  throw InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected), .file = file});
}

[[noreturn]] void throw_damaged(const std::string& file, std::string_view kind, std::string_view reason) {
  throw_image_error(file, fmt::format("the {} is damaged: {}", kind, reason), "a picture that other programs can open");
}

/// Returns a picture of that size with all bytes zero. Throws InputError if it is too large.
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

Image parse_png(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  png_image png{};
  const std::unique_ptr<png_image, void (*)(png_image*)> release(&png, png_image_free);
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
    throw_damaged(file, "PNG", png.message);
  }
  png.format = PNG_FORMAT_RGBA;
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  Image image = empty_image(png.width, png.height, file, limits);
  if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0) {
    throw_damaged(file, "PNG", png.message);
  }
  return image;
}

Image parse_jpeg(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  const std::unique_ptr<void, int (*)(tjhandle)> jpeg(tjInitDecompress(), tjDestroy);
  if (jpeg == nullptr) throw MachineError(fmt::format("JPEG: {}", tjGetErrorStr2(nullptr)));
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  int width = 0;
  int height = 0;
  int subsampling = 0;
  int colours = 0;
  if (tjDecompressHeader3(jpeg.get(), data, bytes.size(), &width, &height, &subsampling, &colours) != 0) {
    throw_damaged(file, "JPEG", tjGetErrorStr2(jpeg.get()));
  }
  Image image = empty_image(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), file, limits);
  // A small JPEG file with thousands of scans would take minutes, so limit the scans.
  if (tjDecompress2(jpeg.get(), data, bytes.size(), image.rgba.data(), width, 0, height, TJPF_RGBA,
                    TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT) != 0) {
    throw_damaged(file, "JPEG", tjGetErrorStr2(jpeg.get()));
  }
  return image;
}

}  // namespace

Image parse_image(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  if (bytes.substr(0, kPngStart.size()) == kPngStart) return parse_png(bytes, file, limits);
  if (bytes.substr(0, kJpegStart.size()) == kJpegStart) return parse_jpeg(bytes, file, limits);
  throw_image_error(file, "this picture cannot be read", "a PNG or a JPEG file");
}

Image read_image(const std::string& path, const SizeLimits& limits) {
  return parse_image(read_file(path, limits.file_bytes), path, limits);
}

}  // namespace meristem
