// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/moving/moving_scene.h"

#include <gtest/gtest.h>

#include "meristem/base/frame.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem::moving_scene_test {

using Kind = MeshMotion::Kind;

Plant one_organ(const Mesh& mesh, const Frame& frame, std::uint64_t name = 7) {
  Plant plant;
  plant.materials.resize(1);
  plant.materials[0].name = "ball";
  plant.prototypes.push_back({"ball", 0, std::make_shared<const Mesh>(mesh)});
  plant.organs.push_back({.frame = frame, .name = name});
  return plant;
}

MovingScene scene_of(const std::vector<Plant>& plants, const MovingLimits& limits = {}) {
  MovingSceneMaker maker(SizeLimits(), limits, plants.size());
  Progress progress;
  for (std::size_t k = 0; k < plants.size(); ++k) maker.add(k, static_cast<double>(k), plants[k], progress);
  return maker.take(progress);
}

Frame at(float x, float scale = 1) { return {Mat3(scale), Vec3(x, 0, 0)}; }

TEST(MovingScene, WhatStaysIsStill) {
  const Plant plant = one_organ(make_cylinder(1, 1, 6), at(0));
  const MovingScene scene = scene_of({plant, plant, plant});
  ASSERT_EQ(scene.motions.size(), 1U);
  EXPECT_EQ(scene.motions[0].kind, Kind::still);
  EXPECT_TRUE(scene.motions[0].frames.empty());
  EXPECT_EQ(scene.times, (std::vector<double>{0, 1, 2}));
}

TEST(MovingScene, WhatMovesAsAWholeIsRigid) {
  const Mesh mesh = make_cylinder(1, 1, 6);
  const MovingScene scene = scene_of({one_organ(mesh, at(0)), one_organ(mesh, at(1)), one_organ(mesh, at(3))});
  ASSERT_EQ(scene.motions.size(), 1U);
  EXPECT_EQ(scene.motions[0].kind, Kind::rigid);
  for (const auto& [key, x] : {std::pair(0, 0.0F), std::pair(1, 1.0F), std::pair(2, 3.0F)}) {
    EXPECT_EQ(scene.motions[0].frames[static_cast<std::size_t>(key)][0].origin.x, x);
  }
}

TEST(MovingScene, WhatIsNotThereYetHasNoSize) {
  const Mesh mesh = make_cylinder(1, 1, 6);
  Plant empty = one_organ(mesh, at(0));
  empty.organs.clear();
  const MovingScene scene = scene_of({empty, one_organ(mesh, at(2)), one_organ(mesh, at(2))});
  ASSERT_EQ(scene.motions.size(), 1U);
  EXPECT_EQ(scene.motions[0].frames[0][0].axes, Mat3(0));
  EXPECT_EQ(scene.motions[0].frames[0][0].origin.x, 2) << "it grows where it comes to be";
}

TEST(MovingScene, AShapeThatChangesKeepsItsTriangles) {
  const MovingScene scene =
      scene_of({one_organ(make_cylinder(1, 1, 6), at(0)), one_organ(make_cylinder(1, 3, 6), at(0))});
  ASSERT_EQ(scene.motions.size(), 1U);
  EXPECT_EQ(scene.motions[0].kind, Kind::shape);
  ASSERT_EQ(scene.motions[0].meshes.size(), 2U);
  EXPECT_EQ(scene.motions[0].meshes[0]->vertex_count(), scene.scene.meshes[0].mesh->vertex_count());
}

TEST(MovingScene, OtherTrianglesAreShownInTheirTime) {
  const MovingScene scene =
      scene_of({one_organ(make_cylinder(1, 1, 6), at(0)), one_organ(make_cylinder(1, 1, 9), at(0))});
  ASSERT_EQ(scene.motions.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(scene.motions[k].kind, Kind::shown);
    EXPECT_EQ(scene.motions[k].shown_at, k);
  }
}

TEST(MovingScene, AColourThatChangesIsATint) {
  const Mesh mesh = make_cylinder(1, 1, 6);
  Plant green = one_organ(mesh, at(0)), red = green;
  green.materials[0].colour = {0.2F, 0.8F, 0.2F};
  red.materials[0].colour = {0.8F, 0.2F, 0.2F};
  const MovingScene scene = scene_of({green, red});
  ASSERT_EQ(scene.motions.size(), 1U);
  EXPECT_EQ(scene.motions[0].kind, Kind::shape);
  ASSERT_EQ(scene.motions[0].tints.size(), 2U);
  EXPECT_GT(scene.motions[0].tints[0][0].g, 1);
  EXPECT_EQ(scene.motions[0].tints[1][0], Vec3(1));
}

/// Adds one axis, straight up, with this colour and name.
void add_axis(float x, Vec3 tint, std::uint64_t name, Plant& plant) {
  Stem stem;
  stem.skeleton.add_node(kNoNode, {x, 0, 0}, 0);
  stem.skeleton.add_node(0, {x, 1, 0}, 0);
  stem.skeleton.radius = {0.1F, 0.1F};
  stem.parts = {{.component = "stem", .tint = tint}};
  stem.axis_names = {name};
  plant.stems.push_back(std::move(stem));
}

TEST(MovingScene, AxesKeepTheirColoursThoughTheyAreThereAtOtherTimes) {
  const Vec3 green(0.2F, 0.8F, 0.2F), brown(0.6F, 0.4F, 0.2F);
  std::vector<Plant> plants(3);
  for (Plant& plant : plants) plant.materials.resize(1);
  add_axis(0, green, 1, plants[0]);
  add_axis(0, brown, 1, plants[1]);
  add_axis(5, green, 2, plants[1]);
  add_axis(5, brown, 2, plants[2]);
  const MovingScene scene = scene_of(plants);
  ASSERT_EQ(scene.motions.size(), 2U) << "the second is still green when the first has turned brown";
  const auto tints_at = [&](std::size_t key) {
    return std::pair(scene.motions[0].tints[key][0], scene.motions[1].tints[key][0]);
  };
  EXPECT_EQ(tints_at(0), std::pair(green, green));
  EXPECT_EQ(tints_at(1), std::pair(brown, green));
  EXPECT_EQ(tints_at(2), std::pair(brown, brown));
}

TEST(MovingScene, ManyPartsMoveByTheirVertices) {
  const Mesh mesh = make_cylinder(1, 1, 6);
  Plant before = one_organ(mesh, at(0));
  Plant after = one_organ(mesh, at(1));
  for (std::uint64_t name = 8; name < 12; ++name) {
    before.organs.push_back({.frame = at(5), .name = name});
    after.organs.push_back({.frame = at(6), .name = name});
  }
  const MovingScene scene = scene_of({before, after}, {.rigid_instances = 3});
  ASSERT_EQ(scene.motions.size(), 1U);
  EXPECT_EQ(scene.motions[0].kind, Kind::shape);
  EXPECT_TRUE(scene.motions[0].meshes.empty()) << "one mesh in five frames";
  EXPECT_EQ(scene.motions[0].frames[0].size(), 5U);
}

TEST(MovingScene, TooMuchIsToldBeforeItIsWritten) {
  const std::vector<Plant> plants{one_organ(make_cylinder(1, 1, 600), at(0)),
                                  one_organ(make_cylinder(1, 3, 600), at(0))};
  try {
    scene_of(plants, {.bytes = 1000});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("fewer keys"), std::string::npos) << error.what();
    EXPECT_EQ(error.diagnostics().at(0).path, "animation");
  }
}

/// Returns a stem of this height and name.
Plant one_axis(float height, std::uint64_t name = 1) {
  Plant plant;
  plant.materials.resize(1);
  add_axis(0, Vec3(1), name, plant);
  plant.stems[0].skeleton.position[1].y = height;
  return plant;
}

TEST(MovingScene, StemsThatMoveTooMuchAreToldAfterTwoKeys) {
  MovingSceneMaker maker(SizeLimits(), {.bytes = 3000}, 16);
  Progress progress;
  maker.add(0, 0, one_axis(1), progress);
  EXPECT_THROW(maker.add(15, 15, one_axis(2), progress), InputError);
}

TEST(MovingScene, StemsThatMoveAreCountedTogether) {
  Plant low, high;
  low.materials.resize(1);
  high.materials.resize(1);
  for (std::uint64_t name = 1; name <= 50; ++name) {
    add_axis(static_cast<float>(name), Vec3(1), name, low);
    add_axis(static_cast<float>(name), Vec3(1), name, high);
    high.stems.back().skeleton.position[1].y = 2;
  }
  MovingSceneMaker maker(SizeLimits(), {.bytes = 10'000}, 2);
  Progress progress;
  maker.add(0, 0, low, progress);
  EXPECT_THROW(maker.add(1, 1, high, progress), InputError);
}

TEST(MovingScene, StemsThatStandStillTakeNothing) {
  const Plant plant = one_axis(1);
  const MovingScene scene = scene_of({plant, plant, plant, plant}, {.bytes = 0});
  ASSERT_EQ(scene.motions.size(), 1U);
  EXPECT_EQ(scene.motions[0].kind, Kind::still);
}

TEST(MovingScene, KeysMayComeInAnyOrder) {
  Plant early = one_axis(1), late = one_axis(2);
  early.materials[0].colour = {0.2F, 0.8F, 0.2F};
  MovingSceneMaker maker(SizeLimits(), {}, 3);
  Progress progress;
  maker.add(0, 0, early, progress);
  maker.add(2, 4, late, progress);
  maker.add(1, 2, early, progress);
  const MovingScene scene = maker.take(progress);
  EXPECT_EQ(scene.times, (std::vector<double>{0, 2, 4}));
  EXPECT_EQ(scene.scene.materials[0].colour, late.materials[0].colour) << "the scene is that of the last key";
  ASSERT_EQ(scene.motions.size(), 1U);
  EXPECT_EQ(scene.motions[0].meshes[1]->positions, scene.motions[0].meshes[0]->positions);
}

TEST(MovingScene, PartsAreCountedWithTheirKeys) {
  Plant plant = one_organ(make_cylinder(1, 1, 6), at(0));
  for (std::uint64_t name = 8; name < 12; ++name) plant.organs.push_back({.frame = at(1), .name = name});
  MovingSceneMaker maker(SizeLimits(), {.part_keys = 99}, 20);
  Progress progress;
  try {
    maker.add(0, 0, plant, progress);
    FAIL() << "five parts in 20 keys";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().at(0).path, "animation");
  }
}

TEST(MovingScene, TrianglesOfAllStemsAreCountedTogether) {
  SizeLimits limits;
  limits.triangles = 100;
  Plant plant = one_axis(1);
  Progress progress;
  MovingSceneMaker(limits, {}, 2).add(0, 0, plant, progress);
  for (std::uint64_t name = 2; name < 30; ++name) add_axis(static_cast<float>(name), Vec3(1), name, plant);
  EXPECT_THROW(MovingSceneMaker(limits, {}, 2).add(0, 0, plant, progress), InputError);
}

TEST(MovingScene, TakingCanBeCancelled) {
  MovingSceneMaker maker(SizeLimits(), {}, 2);
  Progress progress;
  Plant plant = one_organ(make_cylinder(1, 1, 6), at(0));
  maker.add(0, 0, plant, progress);
  maker.add(1, 1, plant, progress);
  progress.cancel();
  EXPECT_THROW(maker.take(progress), Cancelled);
}

}  // namespace meristem::moving_scene_test
