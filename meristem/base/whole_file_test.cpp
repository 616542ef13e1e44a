// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/whole_file.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "tests/support/temporary_folder.h"

namespace meristem::whole_file_test {

namespace fs = std::filesystem;

TEST(WholeFile, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  for (const std::string& content : {std::string(), std::string("a\0\n", 3), std::string(300'000, 'x')}) {
    write_whole_file(folder / "file", content);
    EXPECT_EQ(whole_file(folder / "file"), content);
  }
  EXPECT_EQ(whole_file(folder / "nowhere"), std::nullopt);
  EXPECT_EQ(whole_file(folder.path()), std::nullopt) << "a folder";
}

TEST(WholeFile, FoldersAreMadeWithThoseAbove) {
  const TemporaryFolder folder;
  make_folders(folder / "a/b/c");
  make_folders(folder / "a/b/c");
  EXPECT_TRUE(fs::is_directory(folder / "a/b/c"));
  write_whole_file(folder / "file", "");
  EXPECT_THROW(make_folders(folder / "file/below"), MachineError);
}

TEST(WholeFile, ScratchFoldersGoWithTheirOwners) {
  const TemporaryFolder folder;
  std::string path;
  {
    const ScratchFolder one(folder / "new", "plant-");
    const ScratchFolder other(folder / "new", "plant-");
    path = one.path();
    EXPECT_NE(path, other.path());
    EXPECT_TRUE(fs::path(path).filename().string().starts_with("plant-"));
    write_whole_file(path + "/file", "text");
  }
  EXPECT_TRUE(fs::is_empty(folder / "new"));
  write_whole_file(folder / "file", "");
  EXPECT_THROW(ScratchFolder(folder / "file", "x"), MachineError);
}

}  // namespace meristem::whole_file_test
