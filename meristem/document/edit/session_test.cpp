// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/edit/session.h"

#include <chrono>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/json.h"
#include "tests/support/temporary_folder.h"

namespace meristem::session_test {

namespace fs = std::filesystem;

const std::string kBush = R"json({
  "meristem": 1,
  "seed": 3,
  "variables": {
    "size": {"value": 0.1, "min": 0, "max": 1},  // of leaves
    "many": 12
  },
  "components": {
    "stem": {"type": "tree", "length": 1.50, "radius": 0.01},
    "leaf": {"type": "leaf", "length": "size", "width": 0.03}
  },
  "links": [
    {"from": "stem", "to": "leaf", "kind": "branch", "count": "many"}  // all around
  ]
}
)json";

Session bush() { return {kBush, "bush.json", builtin_components()}; }

std::string with(const std::string& before, const std::string& after) {
  std::string text = kBush;
  const std::size_t at = text.find(before);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, before.size(), after);
}

template <class Act>
Diagnostic error_of(Act act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.diagnostics()[0];
  }
  return {};
}

TEST(Session, EditsTheTextAndTheDocumentWithIt) {
  Session session = bush();
  const Change change = session.edit("stem.length", 2);
  EXPECT_EQ(session.text(), with("1.50", "2"));
  EXPECT_EQ(apply_patch(session.text(), change.inverse), kBush);
  EXPECT_TRUE(session.is_good());
  EXPECT_EQ(*session.document()->source.tree.find("components")->find("stem")->find("length")->number(), 2);
}

TEST(Session, UnderstandsPathsAsOverridesAre) {
  Session session = bush();
  session.edit("size", 0.2);
  EXPECT_EQ(session.text(), with("{\"value\": 0.1", "{\"value\": 0.2"));
  session.undo();
  session.edit("many", 20);
  EXPECT_EQ(session.text(), with("\"many\": 12", "\"many\": 20"));
  session.undo();
  session.edit("links[0].count", 5);
  EXPECT_EQ(session.text(), with("\"many\"}", "5}"));
  session.undo();
  session.edit("components.leaf.curl", 20);
  EXPECT_EQ(session.text(), with("0.03}", "0.03, \"curl\": 20}"));
  EXPECT_EQ(error_of([&] { session.edit("sise", 1); }).nearest, "size");
  EXPECT_EQ(error_of([&] { session.edit("leef.curl", 1); }).nearest, "leaf");
}

TEST(Session, MakesSeveralEditsAsOneStep) {
  Session session = bush();
  session.edit({InsertValue{"components.bud", parse_json(R"({"type": "simple"})")},
                InsertValue{"links[]", Value::List{"leaf", "bud"}}, MoveValue{"links[1]", 0}, UnsetValue{"leaf.width"},
                UnsetValue{"leaf.curl"}});
  EXPECT_TRUE(session.is_good()) << session.errors()[0].text();
  EXPECT_EQ(session.undo_count(), 1U);
  EXPECT_NE(session.text().find("[\n    [\"leaf\", \"bud\"],\n    {\"from\""), std::string::npos) << session.text();
  session.undo();
  EXPECT_EQ(session.text(), kBush);
}

TEST(Session, ChangesNothingWhereOneOfSeveralEditsCannotBeMade) {
  Session session = bush();
  EXPECT_THROW(session.edit({SetValue{"many", 5}, RemoveValue{"leaf.curl"}}), InputError);
  EXPECT_EQ(session.text(), kBush);
  EXPECT_EQ(session.undo_count(), 0U);
}

TEST(Session, TakesStepsBackAndMakesThemAgain) {
  Session session = bush();
  session.edit("many", 5);
  const std::string first = session.text();
  session.edit("size", 0.3);
  const std::string second = session.text();
  session.undo();
  EXPECT_EQ(session.text(), first);
  session.undo();
  EXPECT_EQ(session.text(), kBush);
  EXPECT_FALSE(session.undo());
  session.redo();
  session.redo();
  EXPECT_EQ(session.text(), second);
  EXPECT_FALSE(session.redo());
  session.undo();
  session.edit("seed", 4);
  EXPECT_EQ(session.redo_count(), 0U);
}

TEST(Session, ForgetsTheOldestSteps) {
  Session session(kBush, "bush.json", builtin_components(), {.max_undone = 2});
  for (const double many : {1, 2, 3}) session.edit("many", many);
  EXPECT_EQ(session.undo_count(), 2U);
}

TEST(Session, AnEditThatChangesNothingIsNoStep) {
  Session session = bush();
  EXPECT_TRUE(session.edit("many", 12).patch.empty());
  EXPECT_EQ(session.undo_count(), 0U);
}

TEST(Session, KeepsTheLastGoodDocumentAndGrowthWhereTheTextIsFaulty) {
  Session session = bush();
  Progress progress;
  const std::uint64_t triangles = session.grow(progress).meshes.triangle_count();
  session.edit("leaf.width", "thick");
  EXPECT_FALSE(session.is_good());
  ASSERT_FALSE(session.errors().empty());
  EXPECT_EQ(session.errors()[0].path, "components.leaf.width");
  EXPECT_GT(session.errors()[0].line, 0);
  EXPECT_NE(session.text().find("thick"), std::string::npos);
  EXPECT_EQ(session.grown()->meshes.triangle_count(), triangles);
  EXPECT_EQ(session.grow(progress).meshes.triangle_count(), triangles);
  session.undo();
  EXPECT_TRUE(session.is_good());
}

TEST(Session, HoldsTextThatIsNoJson) {
  Session session = bush();
  session.edit_text({{0, 1, ""}});
  EXPECT_FALSE(session.is_good());
  EXPECT_EQ(error_of([&] { session.edit("many", 1); }).file, "bush.json");
  session.undo();
  EXPECT_EQ(session.text(), kBush);
}

TEST(Session, SaysWhatIsWrongWithADocumentThatNeverWasGood) {
  Session session("{}", "d.json", builtin_components());
  EXPECT_EQ(session.document(), nullptr);
  Progress progress;
  EXPECT_THROW(session.grow(progress), InputError);
}

TEST(Session, OverridesGoBeforeTheTextAndLeaveIt) {
  Session session = bush();
  session.set_overrides({{.path = "many", .value = 3, .name = {}}});
  EXPECT_EQ(session.text(), kBush);
  Progress progress;
  EXPECT_EQ(session.grow(progress).plant.organs.size(), 3U);
  session.set_overrides({});
  EXPECT_EQ(session.grow(progress).plant.organs.size(), 12U);
}

TEST(Session, RemovesAComponentWithItsLinks) {
  Session session = bush();
  session.edit({RemoveValue{"components.leaf"}});
  EXPECT_TRUE(session.is_good());
  EXPECT_NE(session.text().find("\"links\": []"), std::string::npos) << session.text();
}

TEST(Session, TellsWhatGrewAnewByKeys) {
  Session session = bush();
  Progress progress;
  session.grow(progress);
  const SceneKeys before = session.keys();
  EXPECT_EQ(session.difference().batches.added.size(), before.batches.size());
  session.grow(progress);
  EXPECT_TRUE(session.difference().is_empty());

  session.edit("leaf.colour", "#ff0000");
  session.grow(progress);
  EXPECT_TRUE(session.difference().meshes.added.empty());
  EXPECT_EQ(session.difference().materials.added.size(), 1U);
  EXPECT_EQ(session.difference().materials.removed.size(), 1U);
  ASSERT_EQ(session.difference().batches.changed.size(), 1U);
  EXPECT_EQ(session.keys().batches[session.difference().batches.changed[0]].component, "leaf");

  session.edit("leaf.curl", 50);
  session.grow(progress);
  EXPECT_EQ(session.difference().meshes.added.size(), 1U);
  EXPECT_TRUE(session.difference().materials.added.empty());

  session.edit({RemoveValue{"components.leaf"}});
  session.grow(progress);
  EXPECT_EQ(session.difference().batches.removed.size(), 1U);
}

TEST(Session, GrowsTheSameAsWithoutACache) {
  Session session = bush();
  Progress progress;
  session.grow(progress);
  session.edit("stem.radius", 0.02);
  session.grow(progress);
  SceneKeyMaker maker;
  const Document alone = read_document(session.text(), "bush.json", builtin_components());
  EXPECT_TRUE(difference(session.keys(), maker.keys_of(grow_document(alone, progress).meshes)).is_empty());
}

class SessionWithFiles : public ::testing::Test {
 protected:
  SessionWithFiles() {
    write("box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    write("plant.txt", "#include twig.txt as T\n#steps 1\nT\n");
    write("twig.txt", "#steps 1\nF(scale)\n");
    write("leaf.csv", "x,y\n0,0\n0.1,0.4\n0.3,0.5\n0.5,0.4\n");
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::string document() const {
    return R"({"meristem": 1,
      "variables": {"scale": 2},
      "scene": {"obstacles": [{"mesh": "box.obj", "translate": [9, 0, 0]}]},
      "components": {
        "plant": {"type": "lsystem", "file": "plant.txt"},
        "grass": {"type": "grassleaf", "midrib": "leaf.csv", "length": 0.4}
      }})";
  }
  Session session(SessionOptions options = {}) const {
    return {document(), (folder_ / "d.json").string(), builtin_components(), std::move(options)};
  }

  TemporaryFolder folder_;
};

TEST_F(SessionWithFiles, AnEditReadsNothingAnew) {
  Session session = this->session();
  ASSERT_TRUE(session.is_good()) << session.errors()[0].text();
  const ReadStore::Counts before = session.read_counts();
  EXPECT_EQ(before.files_read, 4U);
  session.edit("grass.length", 0.5);
  session.edit("plant.width", 0.01);
  EXPECT_EQ(session.read_counts().files_read, before.files_read);
  EXPECT_EQ(session.read_counts().made, before.made);
  EXPECT_GT(session.read_counts().reused, before.reused);
}

TEST_F(SessionWithFiles, WhatDependsOnAnEditIsMadeAnewOfTheSameFiles) {
  Session session = this->session();
  Progress progress;
  const double length = session.grow(progress).meshes.bounds().size().y;
  session.edit("scale", 3);
  EXPECT_EQ(session.read_counts().files_read, 4U);
  EXPECT_GT(session.grow(progress).meshes.bounds().size().y, length);
}

TEST_F(SessionWithFiles, FilesCountAsFirstReadUntilTheReload) {
  Session session = this->session();
  Progress progress;
  const double height = session.grow(progress).meshes.bounds().size().y;
  write("twig.txt", "#steps 1\nF(3*scale)\n");
  session.edit("grass.length", 0.5);
  EXPECT_EQ(session.grow(progress).meshes.bounds().size().y, height);
  session.reload();
  EXPECT_EQ(session.read_counts().files_read, 5U);
  EXPECT_GT(session.grow(progress).meshes.bounds().size().y, height);
}

TEST_F(SessionWithFiles, AReloadThatFindsAllAsItWasReadsNothing) {
  Session session = this->session();
  session.reload();
  EXPECT_EQ(session.read_counts().files_read, 4U);
}

TEST_F(SessionWithFiles, WhatIsTakenBackIsThereStill) {
  Session session = this->session();
  session.edit({RemoveValue{"components.grass"}});
  session.edit("plant.width", 0.01);
  session.undo();
  session.undo();
  EXPECT_TRUE(session.is_good());
  EXPECT_EQ(session.read_counts().files_read, 4U);
}

TEST_F(SessionWithFiles, NothingOutsideOfTheRootIsRead) {
  const fs::path root = folder_ / "root";
  fs::create_directory(root);
  fs::create_symlink(folder_.path(), root / "out");
  fs::create_symlink("/nowhere/at/all", root / "dangling.obj");
  fs::copy(folder_ / "box.obj", root / "box.obj");
  write("root/include.txt", "#include ../twig.txt as T\n#steps 1\nT\n");
  const auto errors_with = [&](const std::string& component) {
    Session session("{\"meristem\": 1, \"components\": {\"c\": " + component + "}}", (root / "d.json").string(),
                    builtin_components(), {.root = root.string()});
    return session.is_good() ? std::string("none") : session.errors()[0].message + session.errors()[0].nearest;
  };
  const auto crown = [](const std::string& path) {
    return R"({"type": "colonize", "crown": {"mesh": ")" + path + R"("}, "points": 9, "step": 0.1, "influence": 1,
               "kill": 0.2})";
  };
  EXPECT_EQ(errors_with(crown("box.obj")), "none");
  for (const std::string path : {"../box.obj", "out/box.obj", "../nothing.obj", "dangling.obj", "/etc/passwd",
                                 "/etc/passwt", "../root/../box.obj"}) {
    EXPECT_EQ(errors_with(crown(path)), "'" + path + "': this lies outside the folder that may be read");
  }
  EXPECT_EQ(errors_with(crown("../root/box.obj")), "none");
  EXPECT_NE(errors_with(crown("bux.obj")).find("box.obj"), std::string::npos);
  const std::string included = errors_with(R"({"type": "lsystem", "file": "include.txt"})");
  EXPECT_NE(included.find("this lies outside the folder that may be read"), std::string::npos) << included;
}

}  // namespace meristem::session_test
