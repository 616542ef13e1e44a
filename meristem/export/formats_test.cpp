// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/formats.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"

namespace meristem::formats_test {

Diagnostic refusal_of(const std::string& path) {
  try {
    format_of(path);
  } catch (const InputError& error) {
    return error.diagnostics().front();
  }
  ADD_FAILURE() << path << " is accepted";
  return {};
}

TEST(Formats, EveryEndingNamesItsFormat) {
  for (const FileFormat& format : formats()) {
    EXPECT_EQ(format_of("a.b/my oak" + std::string(format.ending)).ending, format.ending);
  }
}

TEST(Formats, TheLongestEndingWins) {
  EXPECT_EQ(format_of("oak.skeleton.ply").ending, ".skeleton.ply");
  EXPECT_EQ(format_of("oak.Skeleton.PLY").ending, ".skeleton.ply");
  EXPECT_EQ(format_of("oak.skeletons.ply").ending, ".ply");
  EXPECT_EQ(format_of("oak.skeleton.ply/a.obj").ending, ".obj");
}

TEST(Formats, StandardOutputTakesTheFirst) { EXPECT_EQ(&format_of("-"), formats().data()); }

TEST(Formats, LevelsOfDetailStandBesideTheFile) {
  EXPECT_EQ(detail_path(format_of("a.b/oak.GLB"), "a.b/oak.GLB", 2), "a.b/oak_lod2.GLB");
  EXPECT_EQ(detail_path(format_of("oak.v2.obj"), "oak.v2.obj", 0), "oak.v2.obj");
}

TEST(Formats, FilesNeedWhatOneOfThemNeeds) {
  const std::vector<const FileFormat*> tables{&format_of("a.csv"), &format_of("a.points.csv")};
  EXPECT_EQ(needed_part(tables), GrownPart::plant);
  EXPECT_TRUE(needed_request(tables).has(TracePart::points));
  const std::vector<const FileFormat*> meshes{&format_of("a.csv"), &format_of("a.glb")};
  EXPECT_EQ(needed_part(meshes), GrownPart::textures);
  EXPECT_FALSE(needed_request(meshes).any());
  EXPECT_EQ(needed_part({}), GrownPart::plant);
}

TEST(Formats, RefusalsNameAllEndingsAndTheNearest) {
  const Diagnostic error = refusal_of("oak.gbl");
  EXPECT_EQ(error.message, "'.gbl' is not a format that can be written");
  for (const FileFormat& format : formats()) EXPECT_NE(error.expected.find(format.ending), std::string::npos);
  EXPECT_EQ(error.nearest, ".glb");
  EXPECT_EQ(refusal_of("oak.skeleton.pyl").nearest, ".skeleton.ply");
  EXPECT_EQ(refusal_of("my.oak.ojb").nearest, ".obj");
  EXPECT_EQ(refusal_of("oak.jpeg").nearest, "");
  EXPECT_EQ(refusal_of("a.glb/oak").message, "'a.glb/oak' has no ending that names a format");
}

}  // namespace meristem::formats_test
