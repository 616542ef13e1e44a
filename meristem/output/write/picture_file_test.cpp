// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/write/picture_file.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"
#include "meristem/base/read_file.h"
#include "meristem/base/read_image.h"
#include "tests/support/temporary_folder.h"

namespace meristem::picture_file_test {

std::string error_of(const std::string& path, bool transparent, const PictureFileOptions& options) {
  try {
    check_picture_file(path, transparent, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PictureFile, TheEndingSaysTheFormat) {
  const TemporaryFolder folder;
  const Image image{2, 1, {10, 20, 30, 255, 200, 100, 50, 255}};
  for (const char* name : {"a.png", "a.PNG", "a.jpg", "a.JPEG"}) {
    const std::string path = (folder / name).string();
    write_picture(image, path);
    const std::string bytes = read_file(path, SizeLimits{}.file_bytes);
    EXPECT_EQ(bytes.starts_with("\x89PNG"), std::string(name).find("PNG") != std::string::npos || name[2] == 'p')
        << name;
    EXPECT_EQ(parse_image(bytes, path, SizeLimits{}).width, 2) << name;
  }
}

TEST(PictureFile, RefusesWhatTheFormatCannotHold) {
  EXPECT_NE(error_of("oak.gif", false, {}).find(".png or .jpg"), std::string::npos);
  EXPECT_NE(error_of("oak", false, {}).find("'oak'"), std::string::npos);
  EXPECT_NE(error_of("oak.jpg", true, {}).find("transparent"), std::string::npos);
  EXPECT_NE(error_of("oak.png", false, {.quality = 80}).find("no quality"), std::string::npos);
  EXPECT_NE(error_of("-", false, {.max_bytes = 80}).find("no quality"), std::string::npos);
  EXPECT_NE(error_of("oak.jpg", false, {.quality = 0}).find("1 to 100"), std::string::npos);
  for (const char* path : {"oak.png", "oak.PNG", "-"}) EXPECT_EQ(error_of(path, true, {}), "") << path;
  EXPECT_EQ(error_of("oak.jpeg", false, {.quality = 80, .max_bytes = 1000}), "");
}

}  // namespace meristem::picture_file_test
