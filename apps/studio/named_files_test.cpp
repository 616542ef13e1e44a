// SPDX-License-Identifier: Apache-2.0
#include "named_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_studio.h"

namespace meristem::studio::named_files_test {

const std::string kCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// A document with an obstacle and a placed document of these names.
std::string garden(const std::string& mesh, const std::string& placed) {
  return R"({"meristem": 1, "scene": {"obstacles": [{"mesh": ")" + mesh +
         R"("}]}, "components": {"plant": {"type": "document", "file": ")" + placed + R"("}}})";
}

/// A studio with the file a/garden.json, which names a/wall.obj, parts/bush.json, and what that names.
class NamedFiles : public testing::Test {
 protected:
  NamedFiles() {
    write("shared/stone.obj", kCube);
    write("a/wall.obj", kCube);
    write("a/parts/bush.json", garden("../../shared/stone.obj", "sunflower"));
    write("a/garden.json", garden("wall.obj", "parts/bush.json"));
  }

  void write(const std::string& path, const std::string& content) {
    fs::create_directories((studio_.folder() / path).parent_path());
    std::ofstream(studio_.folder() / path) << content;
  }
  /// Returns what an answer lists, such as "copied"; of objects their "file" and "reason".
  static std::vector<std::string> list(const Value& answer, const char* name) {
    std::vector<std::string> texts;
    for (const Value& one : *answer.find(name)->list()) {
      texts.push_back(one.text() != nullptr ? *one.text()
                                            : Studio::text_of(one, "file") + ": " + Studio::text_of(one, "reason"));
    }
    return texts;
  }

  Studio studio_;
};

TEST_F(NamedFiles, GoToTheSamePathsFromTheNewPlace) {
  studio_.open(R"("path": "a/garden.json")");
  fs::create_directories(studio_.folder() / "deep/b");
  const Value answer = studio_.save("deep/b/garden.json", "");
  EXPECT_THAT(list(answer, "copied"), testing::ElementsAre("../shared/stone.obj", "parts/bush.json", "wall.obj"));
  EXPECT_THAT(list(answer, "omitted"), testing::IsEmpty());
  EXPECT_TRUE(*answer.find("good")->boolean());
  EXPECT_EQ(studio_.content("deep/shared/stone.obj"), kCube);
  EXPECT_EQ(studio_.content("deep/b/parts/bush.json"), studio_.content("a/parts/bush.json"));
  // The copies are there now, so a further copy beside them needs none.
  EXPECT_THAT(list(studio_.save("deep/b/other.json", ""), "copied"), testing::IsEmpty());
}

TEST_F(NamedFiles, NeverReplaceFilesThatExist) {
  write("b/wall.obj", "v 0 0 0\n");
  write("b/parts/bush.json", studio_.content("a/parts/bush.json"));
  studio_.open(R"("path": "a/garden.json")");
  const Value answer = studio_.save("b/garden.json", "");
  EXPECT_THAT(list(answer, "copied"), testing::IsEmpty());
  EXPECT_THAT(list(answer, "omitted"), testing::ElementsAre("wall.obj: another file with this name is there"));
  EXPECT_EQ(studio_.content("b/wall.obj"), "v 0 0 0\n");
  EXPECT_EQ(studio_.content("b/garden.json"), studio_.content("a/garden.json"));
}

TEST_F(NamedFiles, NeverLeaveTheRootFolder) {
  studio_.open(R"("path": "a/garden.json")");
  const Value answer = studio_.save("garden.json", "");
  EXPECT_THAT(list(answer, "copied"), testing::ElementsAre("parts/bush.json", "wall.obj"));
  EXPECT_THAT(list(answer, "omitted"),
              testing::ElementsAre("../shared/stone.obj: its place would be outside the folder that may be written"));
  EXPECT_FALSE(fs::exists(studio_.folder().parent_path() / "shared/stone.obj"));
}

TEST_F(NamedFiles, AreNotWrittenOverLinks) {
  const TemporaryFolder elsewhere;
  fs::create_directories(studio_.folder() / "b");
  fs::create_directory_symlink(elsewhere.path(), studio_.folder() / "b/parts");
  fs::create_symlink("nothing.obj", studio_.folder() / "b/wall.obj");
  studio_.open(R"("path": "a/garden.json")");
  const Value answer = studio_.save("b/garden.json", "");
  EXPECT_THAT(list(answer, "copied"), testing::IsEmpty());
  EXPECT_EQ(list(answer, "omitted").size(), 2U);
  EXPECT_TRUE(fs::is_empty(elsewhere.path()));
  EXPECT_FALSE(fs::exists(studio_.folder() / "b/nothing.obj"));
}

TEST_F(NamedFiles, OfAbsolutePathsStayWhereTheyAre) {
  write("a/garden.json", garden((studio_.folder() / "a/wall.obj").string(), "sunflower"));
  studio_.open(R"("path": "a/garden.json")");
  fs::create_directories(studio_.folder() / "b");
  const Value answer = studio_.save("b/garden.json", "");
  EXPECT_TRUE(*answer.find("good")->boolean());
  EXPECT_THAT(list(answer, "copied"), testing::IsEmpty());
}

}  // namespace meristem::studio::named_files_test
