// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/read_image.h"

#include <fstream>

#include <gtest/gtest.h>
#include <png.h>
#include <turbojpeg.h>

#include "meristem/base/diagnostic.h"
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

}  // namespace meristem::read_image_test
