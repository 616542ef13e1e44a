// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/write/colour_factors.h"

#include <gtest/gtest.h>

#include "meristem/base/colour.h"
#include "tests/support/sample_scenes.h"

namespace meristem::colour_factors_test {

MeshScene tinted(Vec3 colour, std::vector<Vec3> tints) {
  MeshScene scene = scene_of(triangle(), std::vector<Frame>(tints.size()));
  scene.materials[0].colour = colour;
  scene.meshes[0].tints = std::move(tints);
  return scene;
}

TEST(ColourFactors, WithoutTintsAreTheMaterialsOwn) {
  MeshScene scene = scene_of(triangle(), {Frame()});
  scene.materials[0].colour = {0.2F, 0.4F, 0.6F};
  const ColourFactors factors = colour_factors(scene)[0];
  EXPECT_EQ(factors.base, linear_from_srgb({0.2F, 0.4F, 0.6F}));
  EXPECT_EQ(factors.mean, factors.base);
  EXPECT_FALSE(factors.varies);
  EXPECT_EQ(factors.instance(Vec3(1)), Vec3(1));
}

TEST(ColourFactors, BaseTimesInstanceIsTheInstancesColour) {
  const std::vector<Vec3> tints{{1.5F, 0.5F, 1}, {0.25F, 1.25F, 1}, {1, 1, 0}};
  const MeshScene scene = tinted(Vec3(0.5F), tints);
  const ColourFactors factors = colour_factors(scene)[0];
  EXPECT_TRUE(factors.varies);
  for (const Vec3 tint : tints) {
    const Vec3 share = factors.instance(tint);
    EXPECT_LT(glm::length(factors.base * share - scene.materials[0].tint() * tint), 1e-6F);
    for (int c = 0; c < 3; ++c) EXPECT_LE(share[c], 1);
  }
  EXPECT_EQ(factors.base, scene.materials[0].tint() * Vec3(1.5F, 1.25F, 1));
  EXPECT_LT(glm::length(factors.mean - scene.materials[0].tint() * (tints[0] + tints[1] + tints[2]) / 3.0F), 1e-6F);
}

TEST(ColourFactors, NothingIsBrighterThanOne) {
  const ColourFactors factors = colour_factors(tinted(Vec3(0.9F), {{3, 1, 1}, {0.5F, 0.5F, 0.5F}}))[0];
  EXPECT_EQ(factors.base.r, 1);
  EXPECT_EQ(factors.instance({3, 1, 1}).r, 1);
  EXPECT_NEAR(factors.base.r * factors.instance(Vec3(0.5F)).r, 0.5F * linear_from_srgb(Vec3(0.9F)).r, 1e-6);
  EXPECT_LE(factors.mean.r, 1);
}

TEST(ColourFactors, ABlackChannelStaysBlackAndFinite) {
  const ColourFactors factors = colour_factors(tinted({0, 0.5F, 0.5F}, {{1, 1, 0}, {2, 1, 0}}))[0];
  for (const float channel : {factors.base.r * factors.instance({1, 1, 0}).r, factors.base.b}) EXPECT_EQ(channel, 0);
}

TEST(ColourFactors, CoverMeshesOfOneMaterialWithAndWithoutTints) {
  MeshScene scene = tinted(Vec3(0.5F), {Vec3(0.5F), Vec3(0.25F)});
  scene.meshes.push_back({"leaf", triangle(), 0, {Frame(), Frame()}, {}});
  const ColourFactors factors = colour_factors(scene)[0];
  EXPECT_TRUE(factors.varies);
  EXPECT_EQ(factors.base, scene.materials[0].tint());
  EXPECT_EQ(factors.instance(Vec3(1)), Vec3(1));
  EXPECT_LT(glm::length(factors.mean - scene.materials[0].tint() * (2.75F / 4)), 1e-6F);
}

}  // namespace meristem::colour_factors_test
