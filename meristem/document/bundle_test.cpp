// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/bundle.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/temporary_folder.h"

namespace meristem::bundle_test {

namespace fs = std::filesystem;

constexpr const char* kReed = R"({"meristem": 1, "components": {"stem": {"type": "simple", "shape": "box"}}})";

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

Document read(const fs::path& path) { return read_document(read_text_file(path), path, builtin_components()); }

TEST(DocumentBundle, ReadsTheSameWhereItIsUnpacked) {
  const TemporaryFolder folder;
  const Document plain = read_document(kReed, folder / "a/reed.json", builtin_components());
  const DocumentBundle alone = bundle_of(plain);
  EXPECT_EQ(alone.document, "reed.json");
  ASSERT_EQ(alone.files.size(), 1U);
  EXPECT_EQ(alone.files[0].second, kReed);

  unpack(alone, folder / "copy");
  const Document again = read(folder / "copy/reed.json");
  EXPECT_EQ(again.source.tree, plain.source.tree);
  EXPECT_EQ(bundle_of(again).hash(), alone.hash());
}

TEST(DocumentBundle, KeepsThePlacesOfFilesToEachOther) {
  const TemporaryFolder folder;
  write(folder / "garden/deep/bed.json", "{}");
  write(folder / "garden/parts/points.csv", "x,y\n");
  Document document = read_document(kReed, folder / "garden/deep/bed.json", builtin_components());
  document.source.named_files = {(folder / "garden/deep/../parts/points.csv").string()};
  const DocumentBundle bundle = bundle_of(document);
  EXPECT_EQ(bundle.document, "folder1/bed.json");
  ASSERT_EQ(bundle.files.size(), 2U);
  EXPECT_EQ(bundle.files[1].first, "parts/points.csv");
  unpack(bundle, folder / "copy");
  EXPECT_TRUE(fs::exists(folder / "copy/folder1/../parts/points.csv"));
}

TEST(DocumentBundle, LeavesFilesThatTheTextNamesAbsolutely) {
  const TemporaryFolder folder;
  write(folder / "points.csv", "x,z\n0,0\n");
  for (const bool is_absolute : {false, true}) {
    const std::string table = is_absolute ? (folder / "points.csv").string() : "points.csv";
    write(folder / "bed.json", R"({"meristem": 1, "components": {"row": {"type": "places", "table": ")" + table + R"("},
      "stem": {"type": "simple", "shape": "box"}}, "links": [["row", "stem"]]})");
    const fs::path beside = fs::relative(folder / "bed.json");
    for (const fs::path& name : {folder / "bed.json", beside}) {
      const DocumentBundle bundle = bundle_of(read(name));
      EXPECT_EQ(bundle.files.size(), is_absolute ? 1U : 2U) << name << " " << table;
    }
  }
}

TEST(DocumentBundle, ChangesItsHashWithAnyFile) {
  const TemporaryFolder folder;
  write(folder / "bed.json", "{}");
  write(folder / "points.csv", "x,y\n");
  Document document = read_document(kReed, folder / "bed.json", builtin_components());
  document.source.named_files = {(folder / "points.csv").string()};
  const std::string before = bundle_of(document).hash();
  write(folder / "points.csv", "x,y\n1,2\n");
  EXPECT_NE(bundle_of(document).hash(), before);
  fs::remove(folder / "points.csv");
  EXPECT_THROW(bundle_of(document), std::runtime_error);
}

TEST(DocumentBundle, LeavesShippedModelsToTheProgram) {
  const TemporaryFolder folder;
  write(folder / "models/oak.json", kReed);
  Document document = read_document(kReed, folder / "bed.json", builtin_components());
  document.source.named_files = {(folder / "models/oak.json").string()};
  EXPECT_EQ(bundle_of(document, folder / "models").files.size(), 1U);
  EXPECT_EQ(bundle_of(document).files.size(), 2U);
}

}  // namespace meristem::bundle_test
