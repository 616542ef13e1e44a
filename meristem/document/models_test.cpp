// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/models.h"

#include <filesystem>
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

TEST_F(ModelsTest, FilmsStandInTheirOwnFolder) {
  EXPECT_TRUE(film_names(folder()).empty());
  EXPECT_TRUE(film_names("").empty());
  std::filesystem::create_directory(folder_ / "films");
  for (const char* name : {"primrose.json", "oak.json"}) std::ofstream(folder_ / "films" / name) << "{}";
  EXPECT_EQ(model_names(folder()), (std::vector<std::string>{"birch", "oak"}));
  EXPECT_EQ(film_names(folder()), (std::vector<std::string>{"oak", "primrose"}));
  const std::string film = (folder_ / "films" / "primrose.json").string();
  EXPECT_EQ(find_document("primrose", folder()), film);
  EXPECT_EQ(find_document_within("primrose", folder(), folder()).file, film);
  EXPECT_EQ(find_document("oak", folder()), (folder_ / "oak.json").string()) << "a model goes before a film";
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

/// Returns the file and root that find_document_within() finds, or its message.
std::string found_within(const std::string& path, const std::string& models, const std::string& root) {
  try {
    const DocumentFile found = find_document_within(path, models, root);
    return found.file + " in " + found.root;
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST_F(ModelsTest, StayWithinARoot) {
  namespace fs = std::filesystem;
  const fs::path root = folder_ / "root";
  fs::create_directory(root);
  std::ofstream(root / "own.json") << "{}";
  fs::create_symlink("../oak.json", root / "link.json");
  fs::create_symlink("../nothing.json", root / "dangling.json");
  const std::string own = (root / "own.json").string();
  const std::string missing = (root / "missing.json").string();
  EXPECT_EQ(found_within(own, folder(), root.string()), own + " in " + root.string());
  EXPECT_EQ(found_within(missing, folder(), root.string()), missing + " in " + root.string()) << "it may be looked for";
  EXPECT_EQ(found_within("oak", folder(), root.string()), (folder_ / "oak.json").string() + " in " + folder())
      << "a model may be read, with the files beside it";
  for (const fs::path& path : {folder_ / "oak.json", folder_ / "nothing.json", root / ".." / "oak.json",
                               root / "link.json", root / "dangling.json", root / "x" / ".." / ".." / "oak.json"}) {
    EXPECT_EQ(found_within(path.string(), folder(), root.string()),
              path.string() + ": this lies outside the folder that may be read; expected a file in that folder");
  }
  EXPECT_EQ(found_within(own, folder(), ""), own + " in ");
}

}  // namespace meristem::models_test
