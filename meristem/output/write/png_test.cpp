// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/write/png.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <png.h>

#include "meristem/base/diagnostic.h"

namespace meristem::png_test {

Image gradient(bool opaque) {
  Image image{7, 5, {}};
  for (int i = 0; i < 35; ++i) {
    for (const int value : {i * 7, 255 - i, i * i % 256, opaque ? 255 : i * 3}) {
      image.rgba.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return image;
}

std::string temporary_path() {
  return testing::TempDir() + "png_" + testing::UnitTest::GetInstance()->current_test_info()->name() + ".png";
}

/// Returns the picture that libpng's simple reader decodes from the file.
Image read_back(const std::string& path, bool* has_alpha) {
  png_image reader{};
  reader.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&reader, path.c_str()), 0) << reader.message;
  *has_alpha = (reader.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  reader.format = PNG_FORMAT_RGBA;
  Image image{static_cast<int>(reader.width), static_cast<int>(reader.height), {}};
  image.rgba.resize(PNG_IMAGE_SIZE(reader));
  EXPECT_NE(png_image_finish_read(&reader, nullptr, image.rgba.data(), 0, nullptr), 0) << reader.message;
  return image;
}

TEST(Png, ReadsBackAsItWasWithAlphaOnlyWhereItIsNeeded) {
  for (const bool opaque : {false, true}) {
    const std::string path = temporary_path();
    write_png(gradient(opaque), path);
    bool has_alpha = false;
    const Image image = read_back(path, &has_alpha);
    EXPECT_EQ(image.width, 7);
    EXPECT_EQ(image.height, 5);
    EXPECT_EQ(image.rgba, gradient(opaque).rgba);
    EXPECT_EQ(has_alpha, !opaque);
    std::filesystem::remove(path);
  }
}

TEST(Png, SaysThatItsColoursAreSrgb) {
  const std::string path = temporary_path();
  write_png(gradient(true), path);
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  EXPECT_NE(bytes.find("sRGB"), std::string::npos);
  std::filesystem::remove(path);
}

TEST(Png, MemoryAndFileHoldTheSameBytes) {
  const std::string path = temporary_path();
  for (const PixelKind kind : {PixelKind::srgb, PixelKind::numbers}) {
    write_png(gradient(false), path, kind);
    std::ifstream stream(path, std::ios::binary);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), encode_png(gradient(false), kind));
  }
  std::filesystem::remove(path);
}

TEST(Png, NumbersAreNotCalledColours) {
  EXPECT_EQ(encode_png(gradient(true), PixelKind::numbers).find("sRGB"), std::string::npos);
}

TEST(Png, ReportsAFullDisk) { EXPECT_THROW(write_png(gradient(true), "/dev/full"), MachineError); }

TEST(Png, ReportsARefusedPath) { EXPECT_THROW(write_png(gradient(true), "/nonexistent/a.png"), MachineError); }

TEST(Png, RefusesASizeThatDoesNotFitItsBytes) {
  Image image = gradient(true);
  image.width = 8;
  EXPECT_THROW(write_png(image, temporary_path()), std::invalid_argument);
}

}  // namespace meristem::png_test
