// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/models.h"

#include <fstream>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "tests/support/temporary_folder.h"

namespace meristem::models_test {

class ModelsTest : public testing::Test {
 protected:
  ModelsTest() {
    for (const char* name : {"oak.json", "birch.json", "house.obj"}) std::ofstream(folder_ / name) << "{}";
  }
  std::string folder() const { return folder_.path().string(); }

  TemporaryFolder folder_;
};

TEST_F(ModelsTest, AreTheDocumentsOfTheirFolderInOrder) {
  EXPECT_EQ(model_names(folder()), (std::vector<std::string>{"birch", "oak"}));
  EXPECT_TRUE(model_names("/no/such/folder").empty());
}

TEST_F(ModelsTest, AreFoundByTheirNamesAndFilesByTheirPaths) {
  EXPECT_EQ(find_document("oak", folder()), (folder_ / "oak.json").string());
  EXPECT_EQ(find_document("./oak", folder()), "./oak");
  EXPECT_EQ(find_document("nowhere.json", folder()), "nowhere.json");
}

TEST_F(ModelsTest, SuggestTheNearestName) {
  try {
    find_document("oka", folder());
    FAIL() << "found";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "there is no file and no shipped model 'oka'; expected a document, or the name of a shipped model; did "
        "you mean 'oak'?");
  }
}

}  // namespace meristem::models_test
