// SPDX-License-Identifier: Apache-2.0
// Decodes PNG with libpng, row by row. The pixels equal those of libpng's simplified interface, which reads a whole
// picture in one call and cannot be stopped. In libpng 1.6.39 of Debian 12, that interface decodes interlaced pictures
// of 16 bits wrongly.
#include <csetjmp>
#include <cstring>
#include <string>

#include <png.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/image_readers.h"
#include "meristem/base/reading_stop.h"

namespace meristem {

namespace {

/// The data that libpng's callbacks share.
struct PngSource {
  std::string_view rest;  ///< bytes that libpng has not read
  std::string failure;
};

void read_bytes(png_structp png, png_bytep data, png_size_t size) {
  auto& source = *static_cast<PngSource*>(png_get_io_ptr(png));
  if (size > source.rest.size()) png_error(png, "read beyond end of data");
  std::memcpy(data, source.rest.data(), size);
  source.rest.remove_prefix(size);
}

void keep_error(png_structp png, png_const_charp message) {
  static_cast<PngSource*>(png_get_error_ptr(png))->failure = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

/// Calls a step of libpng. Returns false if libpng reported an error. The step must not own objects with destructors,
/// because libpng leaves it by longjmp.
template <class Step>
bool is_done(png_structp png, const Step& step) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  step();
  return true;
}

/// Converts all kinds of PNG to four channels of 8 bits. Pictures without a profile count as sRGB, also those of 16
/// bits.
void convert_to_rgba(png_structp png, png_infop info) {
  const png_byte colours = png_get_color_type(png, info);
  const bool has_alpha = (colours & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png, info, PNG_INFO_tRNS) != 0;
  png_set_expand(png);
  if ((colours & PNG_COLOR_MASK_COLOR) == 0) png_set_gray_to_rgb(png);
  // The first call sets the assumed gamma of the file, and the second one the gamma of the result.
  png_set_alpha_mode_fixed(png, PNG_ALPHA_PNG, PNG_DEFAULT_sRGB);
  if (png_get_bit_depth(png, info) == 16) png_set_scale_16(png);
  if (!has_alpha) png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
  png_set_alpha_mode_fixed(png, PNG_ALPHA_PNG, PNG_DEFAULT_sRGB);
}

/// libpng's objects for one picture.
class PngReader {
 public:
  PngReader(std::string_view bytes, const std::string& file) : file_(file), source_{bytes, {}} {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, keep_error, ignore_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ != nullptr) return;
    png_destroy_read_struct(&png_, nullptr, nullptr);
    throw MachineError("PNG: out of memory");
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  Image read(const SizeLimits& limits) {
    int passes = 1;
    run([&] {
      png_set_read_fn(png_, &source_, read_bytes);
      png_set_benign_errors(png_, 1);
      png_read_info(png_, info_);
    });
    Image image = empty_image(png_get_image_width(png_, info_), png_get_image_height(png_, info_), file_, limits);
    run([&] {
      convert_to_rgba(png_, info_);
      passes = png_set_interlace_handling(png_);
      png_read_update_info(png_, info_);
    });
    const std::size_t row_bytes = std::size_t{4} * static_cast<std::size_t>(image.width);
    if (png_get_rowbytes(png_, info_) != row_bytes) throw_damaged(file_, "PNG", "unknown kind of pixels");
    for (int pass = 0; pass < passes; ++pass) {
      for (int y = 0; y < image.height; ++y) {
        std::uint8_t* const row = image.rgba.data() + row_bytes * static_cast<std::size_t>(y);
        run([&] { png_read_row(png_, row, nullptr); });
        ReadingStop::check();
      }
    }
    return image;
  }

 private:
  template <class Step>
  void run(const Step& step) {
    if (!is_done(png_, step)) throw_damaged(file_, "PNG", source_.failure);
  }

  const std::string& file_;
  PngSource source_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace

Image parse_png(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  return PngReader(bytes, file).read(limits);
}

}  // namespace meristem
