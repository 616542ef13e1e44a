// SPDX-License-Identifier: Apache-2.0
// The levels of detail of shipped models: an evaluation of minutes under sanitizers, and of seconds without.
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "meristem/export/detail_levels.h"
#include "meristem/shape/outline/outline.h"
#include "tests/support/detailed_model.h"

namespace meristem::levels_of_models_test {

/// Uses the directions of outline.h. A level is drawn at the size at which it is shown.
OutlineOverlap overlap_of(const DetailedModel& model, const MeshScene& scene, int level) {
  Progress progress;
  return outline_overlap(model.grown.meshes, scene, {.directions = 50, .size = pixels_of_level(level)}, progress);
}

class LevelsOfModels : public testing::TestWithParam<const char*> {};

// The levels that grow writes: they end before the first level that is not worth a file.
TEST_P(LevelsOfModels, ThatAreWrittenHaveFewTrianglesAndKeepTheOutline) {
  // The program checks 26 other directions. Between two of them an outline may be a little worse.
  constexpr double kBetweenDirections = 0.01;
  const DetailedModel model(GetParam());
  const Box box = model.grown.meshes.bounds();
  const float tolerance = 0.02F * glm::length(box.size());
  std::uint64_t before = model.grown.meshes.triangle_count();
  for (int level = 1; level <= 2; ++level) {
    const MeshScene scene = model.level(level);
    if (!model.error_of(before, scene, level).empty()) break;
    EXPECT_LE(static_cast<double>(scene.triangle_count()), 0.35 * static_cast<double>(before)) << level;
    EXPECT_GE(overlap_of(model, scene, level).min(), 0.9 - kBetweenDirections) << level;
    const Box coarse = scene.bounds();
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(coarse.low[k], box.low[k] - tolerance) << level;
      EXPECT_LE(coarse.high[k], box.high[k] + tolerance) << level;
    }
    before = scene.triangle_count();
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, LevelsOfModels,
                         testing::Values("low-poly-birch", "low-poly-fir", "low-poly-oak", "low-poly-palm",
                                         "low-poly-poplar", "low-poly-shrub", "low-poly-spruce", "low-poly-willow",
                                         "tulip"),
                         [](const auto& model) {
                           std::string name = model.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(ErrorOfLevel, LevelsOfLargePlantsKeepTheirOutlines) {
  for (const char* name : {"wheat", "fern", "bush"}) {
    const DetailedModel model(name);
    ASSERT_GT(model.grown.meshes.triangle_count(), 50'000U) << name;
    std::uint64_t before = model.grown.meshes.triangle_count();
    for (const auto& [level, min] : {std::pair(1, 0.9), std::pair(2, 0.8)}) {
      const MeshScene scene = model.level(level);
      EXPECT_EQ(model.error_of(before, scene, level), "") << name << level;
      EXPECT_GE(overlap_of(model, scene, level).min(), min) << name << level;
      before = scene.triangle_count();
    }
  }
}

TEST(MakeLevels, EndsBeforeTheFirstLevelThatIsNotWorthAFile) {
  const DetailedModel model("low-poly-poplar");
  const MadeLevels all = made_levels(model, kCoarsestDetail);
  ASSERT_TRUE(all.worthless.has_value());
  EXPECT_EQ(all.worthless->number, static_cast<int>(all.triangles.size()) + 1);
  EXPECT_FALSE(all.worthless->reason.empty());
  std::uint64_t before = model.grown.meshes.triangle_count();
  for (std::size_t k = 0; k < all.triangles.size(); ++k) {
    const int number = static_cast<int>(k) + 1;
    EXPECT_EQ(model.error_of(before, model.level(number), number), "");
    before = all.triangles[k];
  }
  EXPECT_EQ(model.error_of(before, model.level(all.worthless->number), all.worthless->number), all.worthless->reason);
}

TEST(MakeLevels, CrownsWithTunnelsHaveASecondLevel) {
  for (const char* name : {"low-poly-oak", "low-poly-shrub"}) {
    EXPECT_EQ(made_levels(DetailedModel(name), 2).triangles.size(), 2U) << name;
  }
}

}  // namespace meristem::levels_of_models_test
