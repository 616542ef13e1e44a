// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/models.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"

namespace meristem {
namespace {

namespace fs = std::filesystem;

class ModelsTest : public testing::Test {
 protected:
  ModelsTest() : folder_(fs::path(testing::TempDir()) / "models_test") {
    fs::create_directories(folder_);
    for (const char* name : {"oak.json", "birch.json", "house.obj"}) std::ofstream(folder_ / name) << "{}";
  }
  ~ModelsTest() override { fs::remove_all(folder_); }

  const fs::path folder_;
};

TEST_F(ModelsTest, AreTheDocumentsOfTheirFolderInOrder) {
  EXPECT_EQ(model_names(folder_.string()), (std::vector<std::string>{"birch", "oak"}));
  EXPECT_TRUE(model_names("/no/such/folder").empty());
}

TEST_F(ModelsTest, AreFoundByTheirNamesAndFilesByTheirPaths) {
  EXPECT_EQ(find_document("oak", folder_.string()), (folder_ / "oak.json").string());
  EXPECT_EQ(find_document("./oak", folder_.string()), "./oak");
  EXPECT_EQ(find_document("nowhere.json", folder_.string()), "nowhere.json");
}

TEST_F(ModelsTest, SuggestTheNearestName) {
  try {
    find_document("oka", folder_.string());
    FAIL() << "found";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "there is no file and no shipped model 'oka'; expected a document, or the name of a shipped model; did "
        "you mean 'oak'?");
  }
}

}  // namespace
}  // namespace meristem
