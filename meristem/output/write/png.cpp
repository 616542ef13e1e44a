// SPDX-License-Identifier: Apache-2.0
// Encodes PNG with libpng. The compression level and filters are fixed, so that equal pictures give equal bytes.
#include "meristem/output/write/png.h"

#include <csetjmp>
#include <exception>
#include <stdexcept>
#include <vector>

#include <png.h>
#include <zlib.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/function_ref.h"

namespace meristem {

namespace {

/// The data that libpng's callbacks share. libpng is written in C and reports errors by longjmp, so exceptions are
/// stored here until its frames are gone.
struct PngTarget {
  FunctionRef<void(const void* data, std::size_t size)> write;
  std::exception_ptr failure;
};

void write_bytes(png_structp png, png_bytep data, png_size_t size) {
  auto& target = *static_cast<PngTarget*>(png_get_io_ptr(png));
  try {
    target.write(data, size);
    return;
  } catch (...) {
    target.failure = std::current_exception();
  }
  png_error(png, "write");
}

void flush_nothing(png_structp) {}

void keep_error(png_structp png, png_const_charp message) {
  auto& target = *static_cast<PngTarget*>(png_get_error_ptr(png));
  if (!target.failure) {
    target.failure = std::make_exception_ptr(MachineError(std::string("PNG: ") + message));
  }
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

bool is_opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 255) return false;
  }
  return true;
}

/// The input of libpng: rows of bytes, from the top.
struct PngRows {
  int width, height;
  int bits;         // bits per channel
  int colour_type;  // colour type of libpng
  const std::uint8_t* bytes;
  std::size_t row_bytes;
  bool skips_alpha;  // if true, every fourth byte is skipped
};

/// No object with a destructor may exist here, because libpng leaves this function by longjmp.
void write_rows(png_structp png, png_infop info, const PngRows& rows, PixelKind kind, PngPacking packing) {
  if (setjmp(png_jmpbuf(png)) != 0) return;
  png_set_IHDR(png, info, static_cast<png_uint_32>(rows.width), static_cast<png_uint_32>(rows.height), rows.bits,
               rows.colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (kind == PixelKind::srgb) png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  // Set explicitly, so that the bytes do not change with libpng's defaults.
  png_set_compression_level(png, 6);
  if (packing == PngPacking::quick) {
    // Random textures repeat nothing: searching for repetitions takes five sixths of the time for 5 % of the bytes.
    // These two filters give files as small as all filters together.
    png_set_compression_strategy(png, Z_RLE);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP | PNG_FILTER_PAETH);
  } else {
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
  }
  png_write_info(png, info);
  if (rows.skips_alpha) png_set_filler(png, 0, PNG_FILLER_AFTER);
  for (int y = 0; y < rows.height; ++y) png_write_row(png, rows.bytes + rows.row_bytes * y);
  png_write_end(png, info);
}

/// Passes the bytes of the PNG to `write`, in order.
void stream_rows(const PngRows& rows, PixelKind kind, PngPacking packing,
                 FunctionRef<void(const void* data, std::size_t size)> write) {
  PngTarget target{write, nullptr};
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &target, keep_error, ignore_warning);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  if (info != nullptr) {
    png_set_write_fn(png, &target, write_bytes, flush_nothing);
    write_rows(png, info, rows, kind, packing);
  } else {
    target.failure = std::make_exception_ptr(MachineError("PNG: libpng could not be set up"));
  }
  png_destroy_write_struct(&png, &info);
  if (target.failure) std::rethrow_exception(target.failure);
}

void stream_png(const Image& image, PixelKind kind, PngPacking packing,
                FunctionRef<void(const void* data, std::size_t size)> write) {
  if (image.width < 1 || image.height < 1 ||
      image.rgba.size() != std::size_t{4} * image.width * static_cast<std::size_t>(image.height)) {
    throw std::invalid_argument("a picture's size and its bytes do not agree");
  }
  const bool opaque = is_opaque(image);
  const PngRows rows{.width = image.width,
                     .height = image.height,
                     .bits = 8,
                     .colour_type = opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA,
                     .bytes = image.rgba.data(),
                     .row_bytes = std::size_t{4} * image.width,
                     .skips_alpha = opaque};
  stream_rows(rows, kind, packing, write);
}

}  // namespace

void write_png(const Image& image, const std::string& path, PixelKind kind) {
  AtomicFile file(path);
  stream_png(image, kind, PngPacking::small, [&](const void* data, std::size_t size) { file.write(data, size); });
  file.commit();
}

std::string encode_png(const Image& image, PixelKind kind, PngPacking packing) {
  std::string bytes;
  stream_png(image, kind, packing,
             [&](const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); });
  return bytes;
}

std::string encode_grey_png(int width, int height, std::span<const std::uint16_t> grey) {
  if (width < 1 || height < 1 || grey.size() != std::size_t{1} * width * height) {
    throw std::invalid_argument("a picture's size and its numbers do not agree");
  }
  std::vector<std::uint8_t> big_endian;
  big_endian.reserve(2 * grey.size());
  for (const std::uint16_t number : grey) {
    big_endian.push_back(static_cast<std::uint8_t>(number >> 8U));
    big_endian.push_back(static_cast<std::uint8_t>(number & 255U));
  }
  const PngRows rows{.width = width,
                     .height = height,
                     .bits = 16,
                     .colour_type = PNG_COLOR_TYPE_GRAY,
                     .bytes = big_endian.data(),
                     .row_bytes = std::size_t{2} * width,
                     .skips_alpha = false};
  std::string bytes;
  stream_rows(rows, PixelKind::numbers, PngPacking::small,
              [&](const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); });
  return bytes;
}

}  // namespace meristem
