// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/detail_levels.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/detailed_model.h"

namespace meristem::detail_levels_test {

// tests/levels checks the levels of all shipped models.
TEST(ErrorOfLevel, IsTooManyTrianglesOrAnotherOutline) {
  const DetailedModel model("low-poly-birch");
  const MeshScene level = model.level(1);
  EXPECT_EQ(model.error_of(model.grown.meshes.triangle_count(), level, 1), "");
  EXPECT_NE(model.error_of(2 * level.triangle_count(), level, 1), "");
  MeshScene bare = level;
  bare.meshes.resize(1);
  EXPECT_NE(model.error_of(model.grown.meshes.triangle_count(), bare, 1).find("outline"), std::string::npos);
}

TEST(ErrorOfLevel, ALevelOfALargePlantWithoutItsLeavesIsNone) {
  const DetailedModel model("bush");
  MeshScene bare = model.level(1);
  std::erase_if(bare.meshes, [](const MeshInstances& part) { return part.component == "leaf"; });
  EXPECT_NE(model.error_of(model.grown.meshes.triangle_count(), bare, 1).find("80 % are wanted"), std::string::npos);
}

TEST(MakeLevels, GivesAsManyAsAreAskedForWhereAllAreWorthAFile) {
  const DetailedModel model("low-poly-poplar");
  EXPECT_TRUE(made_levels(model, 0).triangles.empty());
  const MadeLevels one = made_levels(model, 1);
  EXPECT_EQ(one.triangles.size(), 1U);
  EXPECT_FALSE(one.worthless.has_value());
}

}  // namespace meristem::detail_levels_test
