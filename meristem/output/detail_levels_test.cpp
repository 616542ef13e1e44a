// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/detail_levels.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/document/models.h"
#include "meristem/shape/outline.h"

namespace meristem::detail_levels_test {

/// A shipped model.
struct Model {
  Document document;
  GrownDocument grown;

  explicit Model(const std::string& name) : document(read(name)) {
    Progress progress;
    grown = grow_document(document, progress, {.up_to = GrownPart::meshes});
  }

  MeshScene level(int number) const {
    Progress progress;
    return mesh_detail(document, grown.plant, {.level = number}, progress);
  }

  static Document read(const std::string& name) {
    const std::string file = model_path(std::string(MERISTEM_SOURCE_DIR) + "/models", name);
    return read_document(read_text_file(file), file, builtin_components());
  }
};

/// The directions are those of outline.h; a level is drawn as large as it is meant to be seen.
OutlineOverlap overlap_of(const Model& model, const MeshScene& scene, int level) {
  Progress progress;
  return outline_overlap(model.grown.meshes, scene, {.directions = 50, .size = pixels_of_level(level)}, progress);
}

std::string fault_of(const Model& model, std::uint64_t before, const MeshScene& scene, int level) {
  Progress progress;
  return fault_of_level(model.grown.meshes, before, scene, level, progress);
}

class LevelsOfModels : public testing::TestWithParam<const char*> {};

// What grow writes: a level that is not worth a file ends the levels.
TEST_P(LevelsOfModels, ThatAreWrittenHaveFewTrianglesAndKeepTheOutline) {
  // The program looks from 26 other directions: between two of them an outline may be a little worse.
  constexpr double kBetweenDirections = 0.01;
  const Model model(GetParam());
  const Box box = model.grown.meshes.bounds();
  const float tolerance = 0.02F * glm::length(box.size());
  std::uint64_t before = model.grown.meshes.triangle_count();
  for (int level = 1; level <= 2; ++level) {
    const MeshScene scene = model.level(level);
    if (!fault_of(model, before, scene, level).empty()) break;
    EXPECT_LE(static_cast<double>(scene.triangle_count()), 0.35 * static_cast<double>(before)) << level;
    EXPECT_GE(overlap_of(model, scene, level).least(), 0.9 - kBetweenDirections) << level;
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

TEST(FaultOfLevel, IsTooManyTrianglesOrAnotherOutline) {
  const Model model("low-poly-birch");
  const MeshScene level = model.level(1);
  EXPECT_EQ(fault_of(model, model.grown.meshes.triangle_count(), level, 1), "");
  EXPECT_NE(fault_of(model, 2 * level.triangle_count(), level, 1), "");
  MeshScene bare = level;
  bare.meshes.resize(1);
  EXPECT_NE(fault_of(model, model.grown.meshes.triangle_count(), bare, 1).find("outline"), std::string::npos);
}

TEST(FaultOfLevel, LevelsOfLargePlantsKeepTheirOutlines) {
  for (const char* name : {"wheat", "fern", "bush"}) {
    const Model model(name);
    ASSERT_GT(model.grown.meshes.triangle_count(), 50'000U) << name;
    std::uint64_t before = model.grown.meshes.triangle_count();
    for (const auto& [level, least] : {std::pair(1, 0.9), std::pair(2, 0.8)}) {
      const MeshScene scene = model.level(level);
      EXPECT_EQ(fault_of(model, before, scene, level), "") << name << level;
      EXPECT_GE(overlap_of(model, scene, level).least(), least) << name << level;
      before = scene.triangle_count();
    }
  }
}

TEST(FaultOfLevel, ALevelOfALargePlantWithoutItsLeavesIsNone) {
  const Model model("bush");
  MeshScene bare = model.level(1);
  std::erase_if(bare.meshes, [](const MeshInstances& part) { return part.component == "leaf"; });
  EXPECT_NE(fault_of(model, model.grown.meshes.triangle_count(), bare, 1).find("80 % are wanted"), std::string::npos);
}

struct MadeLevels {
  std::vector<std::uint64_t> triangles;  // of those that were given, from level 1 on
  std::optional<WorthlessLevel> worthless;
};

MadeLevels made_levels(const Model& model, int count) {
  MadeLevels made;
  Progress progress;
  const auto take = [&made](int number, const MeshScene& level) {
    made.triangles.push_back(level.triangle_count());
    EXPECT_EQ(made.triangles.size(), static_cast<std::size_t>(number));
  };
  made.worthless = make_levels(model.document, model.grown.plant, model.grown.meshes, count, take, progress);
  return made;
}

TEST(MakeLevels, EndsBeforeTheFirstLevelThatIsNotWorthAFile) {
  const Model model("low-poly-poplar");
  const MadeLevels all = made_levels(model, kCoarsestDetail);
  ASSERT_TRUE(all.worthless.has_value());
  EXPECT_EQ(all.worthless->number, static_cast<int>(all.triangles.size()) + 1);
  EXPECT_FALSE(all.worthless->reason.empty());
  std::uint64_t before = model.grown.meshes.triangle_count();
  for (std::size_t k = 0; k < all.triangles.size(); ++k) {
    const int number = static_cast<int>(k) + 1;
    EXPECT_EQ(fault_of(model, before, model.level(number), number), "");
    before = all.triangles[k];
  }
  EXPECT_EQ(fault_of(model, before, model.level(all.worthless->number), all.worthless->number), all.worthless->reason);
}

TEST(MakeLevels, CrownsWithTunnelsHaveASecondLevel) {
  for (const char* name : {"low-poly-oak", "low-poly-shrub"}) {
    EXPECT_EQ(made_levels(Model(name), 2).triangles.size(), 2U) << name;
  }
}

TEST(MakeLevels, GivesAsManyAsAreAskedForWhereAllAreWorthAFile) {
  const Model model("low-poly-poplar");
  EXPECT_TRUE(made_levels(model, 0).triangles.empty());
  const MadeLevels one = made_levels(model, 1);
  EXPECT_EQ(one.triangles.size(), 1U);
  EXPECT_FALSE(one.worthless.has_value());
}

}  // namespace meristem::detail_levels_test
