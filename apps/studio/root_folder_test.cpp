// SPDX-License-Identifier: Apache-2.0
#include "root_folder.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "refusal.h"
#include "tests/support/temporary_folder.h"
#include "text_units.h"

namespace meristem::studio::root_folder_test {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

std::string content(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

template <class Act>
std::string refusal(Act act) {
  try {
    act();
  } catch (const Refusal& refused) {
    return refused.what();
  }
  return "";
}

/// A folder in a folder; what stands beside it is nobody's business.
struct TwoFolders {
  TemporaryFolder outer;
  fs::path inner = outer / "inner";

  TwoFolders() {
    fs::create_directory(inner);
    write(outer / "secret.json", "secret");
    write(inner / "oak.json", "{}");
    fs::create_directory(inner / "more");
    write(inner / "more" / "elm.json", "{ }");
    write(inner / ".hidden", "x");
    fs::create_symlink(outer / "secret.json", inner / "link.json");
    fs::create_symlink(outer.path(), inner / "up");
  }
};

TEST(RootFolder, ReadsWhatIsInIt) {
  const TwoFolders folders;
  const RootFolder root(folders.inner.string());
  EXPECT_EQ(root.read("oak.json"), "{}");
  EXPECT_EQ(root.read("more/elm.json"), "{ }");
  EXPECT_EQ(root.relative((folders.inner / "more" / "elm.json").string()), "more/elm.json");
  EXPECT_EQ(root.relative((folders.outer / "secret.json").string()), std::nullopt);
}

TEST(RootFolder, RefusesAllThatLeadsOutWithTheSameWord) {
  const TwoFolders folders;
  const RootFolder root(folders.inner.string());
  const std::string there = (folders.outer / "secret.json").string();
  const std::string word = refusal([&] { root.read("../secret.json"); });
  EXPECT_NE(word, "");
  for (const std::string& path :
       {there, std::string("/etc/passwd"), std::string("../nothing.json"), std::string("link.json"),
        std::string("up/secret.json"), std::string("up/nothing.json"), std::string("more/../../secret.json"),
        std::string("."), std::string(".."), std::string(".hidden"), std::string("more//elm.json"),
        std::string("more/"), std::string("a\0b", 3), std::string(5000, 'a')}) {
    EXPECT_EQ(refusal([&] { root.read(path); }), word) << path;
  }
  for (const char* path : {"../secret.json", "link.json", "up/secret.json", "up/new.json"})
    EXPECT_EQ(refusal([&] { root.write(path, "x", {}, true); }), word) << path;
  EXPECT_EQ(content(folders.outer / "secret.json"), "secret");
}

TEST(RootFolder, ListsWithoutWhatIsHiddenOrLeadsOut) {
  const TwoFolders folders;
  const std::vector<FolderEntry> entries = RootFolder(folders.inner.string()).list("");
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].name, "more");
  EXPECT_TRUE(entries[0].is_folder);
  EXPECT_EQ(entries[1].name, "oak.json");
  EXPECT_EQ(entries[1].bytes, 2U);
}

TEST(RootFolder, WritesOverWhatWasOpenedAlone) {
  const TwoFolders folders;
  const RootFolder root(folders.inner.string());
  root.write("oak.json", "first", text_hash("{}"), false);
  EXPECT_EQ(content(folders.inner / "oak.json"), "first");
  EXPECT_NE(refusal([&] { root.write("oak.json", "second", text_hash("{}"), false); }).find("somebody else"),
            std::string::npos);
  EXPECT_NE(refusal([&] { root.write("oak.json", "second", std::nullopt, false); }).find("somebody else"),
            std::string::npos);
  EXPECT_NE(refusal([&] { root.write("new.json", "x", text_hash("{}"), false); }).find("no longer exists"),
            std::string::npos);
  EXPECT_EQ(content(folders.inner / "oak.json"), "first");
  root.write("oak.json", "second", std::nullopt, true);
  root.write("new.json", "third", std::nullopt, false);
  EXPECT_EQ(content(folders.inner / "oak.json"), "second");
  EXPECT_EQ(content(folders.inner / "new.json"), "third");
  EXPECT_NE(refusal([&] { root.write("oak.json", "caf\xE9", std::nullopt, true); }).find("not UTF-8 at its byte 4"),
            std::string::npos);
  EXPECT_EQ(content(folders.inner / "oak.json"), "second");
  EXPECT_NE(refusal([&] { root.write("oak.txt", "x", {}, false); }).find(".json"), std::string::npos);
}

}  // namespace meristem::studio::root_folder_test
