// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/read_image.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>
#include <turbojpeg.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/reading_stop.h"
#include "tests/support/temporary_folder.h"

namespace meristem::read_image_test {

/// Returns a picture with colours that JPEG keeps well. Alpha falls from row to row.
Image sample() {
  Image image{24, 16, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (const int value : {8 * x, 12 * y, 100, 255 - 10 * y}) {
        image.rgba.push_back(static_cast<std::uint8_t>(value));
      }
    }
  }
  return image;
}

std::string png_bytes(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = 0;
  EXPECT_NE(png_image_write_to_memory(&png, nullptr, &size, 0, image.rgba.data(), 0, nullptr), 0) << png.message;
  std::string bytes(size, '\0');
  EXPECT_NE(png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgba.data(), 0, nullptr), 0) << png.message;
  return bytes;
}

std::string jpeg_bytes(const Image& image) {
  const tjhandle jpeg = tjInitCompress();
  unsigned char* data = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(jpeg, image.rgba.data(), image.width, 0, image.height, TJPF_RGBA, &data, &size, TJSAMP_444, 98,
                        TJFLAG_ACCURATEDCT),
            0);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  tjFree(data);
  tjDestroy(jpeg);
  return bytes;
}

Diagnostic error_of(std::string_view bytes, const SizeLimits& limits = {}) {
  try {
    parse_image(bytes, "bark.png", limits);
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().front().file, "bark.png");
    return error.diagnostics().front();
  }
  ADD_FAILURE() << "was read";
  return {};
}

TEST(ReadImage, GivesAPngsPixelsWithTheirAlpha) {
  const Image image = parse_image(png_bytes(sample()), "bark.png", {});
  EXPECT_EQ(image.width, 24);
  EXPECT_EQ(image.height, 16);
  EXPECT_EQ(image.rgba, sample().rgba);
}

TEST(ReadImage, GivesAJpegsPixelsOpaque) {
  const Image image = parse_image(jpeg_bytes(sample()), "bark.jpg", {});
  ASSERT_EQ(image.rgba.size(), sample().rgba.size());
  for (std::size_t k = 0; k < image.rgba.size(); ++k) {
    EXPECT_NEAR(image.rgba[k], k % 4 == 3 ? 255 : sample().rgba[k], 8) << k;
  }
}

TEST(ReadImage, TellsFormatsByTheirBytesAndNotByTheirNames) {
  const TemporaryFolder folder;
  const std::string path = (folder / "bark.jpg").string();
  std::ofstream(path, std::ios::binary) << png_bytes(sample());
  EXPECT_EQ(read_image(path, {}).rgba, sample().rgba);
}

TEST(ReadImage, RefusesOtherFiles) {
  const Diagnostic error = error_of("GIF89a and so on");
  EXPECT_EQ(error.message, "this picture cannot be read");
  EXPECT_EQ(error.expected, "a PNG or a JPEG file");
}

TEST(ReadImage, RefusesTruncatedPicturesOfBothKinds) {
  for (const std::string& bytes : {png_bytes(sample()), jpeg_bytes(sample())}) {
    for (const std::size_t size : {std::size_t{10}, bytes.size() / 2, bytes.size() - 20}) {
      EXPECT_NE(error_of(bytes.substr(0, size)).message.find("is damaged: "), std::string::npos) << size;
    }
  }
}

TEST(ReadImage, RefusesAPngWithAWrongChecksum) {
  std::string bytes = png_bytes(sample());
  bytes[bytes.size() / 2] ^= 0x10;
  EXPECT_NE(error_of(bytes).message.find("the PNG is damaged: "), std::string::npos);
}

TEST(ReadImage, RefusesMorePixelsThanAllowedByTheHeaderAlone) {
  SizeLimits limits;
  limits.picture_pixels = 24 * 16 - 1;
  for (const std::string& bytes : {png_bytes(sample()), jpeg_bytes(sample())}) {
    EXPECT_NE(error_of(bytes, limits).message.find("pixels of a picture"), std::string::npos);
  }
  limits.picture_pixels = 24 * 16;
  EXPECT_FALSE(parse_image(png_bytes(sample()), "bark.png", limits).is_empty());
}

struct PngKind {
  const char* name;
  int colours;  // colour type of libpng
  int bits;     // bits per channel
  int interlace = PNG_INTERLACE_NONE;
  double gamma = 0;      // 0: none is written
  bool has_key = false;  // true: one colour, or colours of the palette, are transparent
};

/// Returns a PNG of that kind with mixed bytes as its rows.
std::string png_of_kind(const PngKind& kind) {
  constexpr int kWidth = 21;
  constexpr int kHeight = 13;
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const auto append = [](png_structp to, png_bytep data, png_size_t size) {
    static_cast<std::string*>(png_get_io_ptr(to))->append(reinterpret_cast<const char*>(data), size);
  };
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_IHDR(png, info, kWidth, kHeight, kind.bits, kind.colours, kind.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (kind.gamma > 0) png_set_gAMA(png, info, kind.gamma);
  std::vector<png_color> palette(std::size_t{1} << std::min(kind.bits, 8));
  for (std::size_t k = 0; k < palette.size(); ++k) {
    const auto part = [k](std::size_t factor) { return static_cast<png_byte>(factor * k % 256); };
    palette[k] = {part(7), part(31), part(111)};
  }
  const png_byte alphas[] = {0, 100};
  png_color_16 key{};
  if (kind.colours == PNG_COLOR_TYPE_PALETTE) {
    png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    if (kind.has_key) png_set_tRNS(png, info, alphas, 2, nullptr);
  } else if (kind.has_key) {
    png_set_tRNS(png, info, nullptr, 0, &key);
  }
  png_write_info(png, info);
  const std::size_t row_bytes = png_get_rowbytes(png, info);
  std::vector<png_byte> rows(row_bytes * kHeight);
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = static_cast<png_byte>(k % 5 == 0 ? 0 : (k * k * 37 + k) >> 3);
  const int passes = png_set_interlace_handling(png);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t y = 0; y < kHeight; ++y) png_write_row(png, rows.data() + y * row_bytes);
  }
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

/// Decodes a whole PNG in one call of libpng.
std::vector<std::uint8_t> decoded_at_once(const std::string& bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()), 0) << png.message;
  png.format = PNG_FORMAT_RGBA;
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  std::vector<std::uint8_t> rgba(PNG_IMAGE_SIZE(png));
  EXPECT_NE(png_image_finish_read(&png, nullptr, rgba.data(), 0, nullptr), 0) << png.message;
  return rgba;
}

TEST(ReadImage, AllKindsOfPngHaveThePixelsOfLibpngsOwnReader) {
  const PngKind kinds[] = {{"rgb", PNG_COLOR_TYPE_RGB, 8},
                           {"rgb with a transparent colour", PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_NONE, 0, true},
                           {"rgba interlaced", PNG_COLOR_TYPE_RGB_ALPHA, 8, PNG_INTERLACE_ADAM7},
                           {"rgb of 16 bits", PNG_COLOR_TYPE_RGB, 16},
                           {"rgba of 16 bits", PNG_COLOR_TYPE_RGB_ALPHA, 16, PNG_INTERLACE_ADAM7},
                           {"linear rgb of 16 bits", PNG_COLOR_TYPE_RGB, 16, PNG_INTERLACE_NONE, 1},
                           {"linear rgba", PNG_COLOR_TYPE_RGB_ALPHA, 8, PNG_INTERLACE_NONE, 1},
                           {"gray of 1 bit", PNG_COLOR_TYPE_GRAY, 1},
                           {"gray of 4 bits", PNG_COLOR_TYPE_GRAY, 4, PNG_INTERLACE_ADAM7, 0, true},
                           {"gray with a gamma", PNG_COLOR_TYPE_GRAY, 8, PNG_INTERLACE_NONE, 0.6},
                           {"gray of 16 bits", PNG_COLOR_TYPE_GRAY, 16, PNG_INTERLACE_NONE, 0, true},
                           {"gray and alpha", PNG_COLOR_TYPE_GRAY_ALPHA, 8},
                           {"palette of 2 bits", PNG_COLOR_TYPE_PALETTE, 2},
                           {"palette of 8 bits", PNG_COLOR_TYPE_PALETTE, 8, PNG_INTERLACE_ADAM7, 0, true},
                           {"linear palette", PNG_COLOR_TYPE_PALETTE, 8, PNG_INTERLACE_NONE, 1, true}};
  for (const PngKind& kind : kinds) {
    SCOPED_TRACE(kind.name);
    // libpng 1.6.39 of Debian 12 decodes interlaced pictures of 16 bits wrongly in one call.
    PngKind plain = kind;
    plain.interlace = PNG_INTERLACE_NONE;
    EXPECT_EQ(parse_image(png_of_kind(kind), "bark.png", {}).rgba, decoded_at_once(png_of_kind(plain)));
  }
}

std::string jpeg_with(const Image& image, int subsampling, int flags) {
  const tjhandle jpeg = tjInitCompress();
  unsigned char* data = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(jpeg, image.rgba.data(), image.width, 0, image.height, TJPF_RGBA, &data, &size, subsampling, 80,
                        TJFLAG_ACCURATEDCT | flags),
            0);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  tjFree(data);
  tjDestroy(jpeg);
  return bytes;
}

TEST(ReadImage, AllKindsOfJpegHaveThePixelsOfLibjpegTurbosOwnReader) {
  for (const int subsampling : {TJSAMP_444, TJSAMP_420, TJSAMP_GRAY}) {
    for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
      const std::string bytes = jpeg_with(sample(), subsampling, flags);
      const Image image = parse_image(bytes, "bark.jpg", {});
      std::vector<std::uint8_t> expected(image.rgba.size());
      const tjhandle jpeg = tjInitDecompress();
      EXPECT_EQ(tjDecompress2(jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), expected.data(),
                              image.width, 0, image.height, TJPF_RGBA, TJFLAG_ACCURATEDCT),
                0);
      tjDestroy(jpeg);
      EXPECT_EQ(image.rgba, expected) << subsampling << " " << flags;
    }
  }
}

/// The rows are counted, because times differ from machine to machine.
TEST(ReadImage, IsStoppedAfterAnyRow) {
  const Image tall{8, 4096, std::vector<std::uint8_t>(std::size_t{4} * 8 * 4096, 200)};
  for (const std::string& bytes :
       {png_bytes(tall), jpeg_with(tall, TJSAMP_444, 0), jpeg_with(tall, TJSAMP_444, TJFLAG_PROGRESSIVE)}) {
    const std::uint64_t before = ReadingStop::check_count();
    parse_image(bytes, "tall", {});
    EXPECT_GE(ReadingStop::check_count() - before, 4096U);
    Progress progress;
    const ReadingStop stop(&progress);
    parse_image(bytes, "tall", {});
    progress.cancel();
    EXPECT_THROW(parse_image(bytes, "tall", {}), Cancelled);
  }
}

/// All scans of a progressive JPEG are read before its first row.
TEST(ReadImage, IsStoppedInEachScanOfAProgressiveJpeg) {
  const Image tall{8, 4096, std::vector<std::uint8_t>(std::size_t{4} * 8 * 4096, 200)};
  const auto checks = [&](int flags) {
    const std::uint64_t before = ReadingStop::check_count();
    parse_image(jpeg_with(tall, TJSAMP_444, flags), "tall", {});
    return ReadingStop::check_count() - before;
  };
  EXPECT_GE(checks(TJFLAG_PROGRESSIVE), checks(0) + 4096U / 8);
}

}  // namespace meristem::read_image_test
