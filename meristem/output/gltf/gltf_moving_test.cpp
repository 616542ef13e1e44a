// SPDX-License-Identifier: Apache-2.0
// Moving scenes, checked as a reader of the file sees them.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "meristem/shape/solid/primitives.h"
#include "tests/support/read_glb.h"

namespace meristem::gltf_moving_test {

using Kind = MeshMotion::Kind;

std::shared_ptr<const Mesh> cylinder(double height) {
  return std::make_shared<const Mesh>(make_cylinder(0.1, height, 6));
}

/// Returns a trunk that does not move, a stem that rises over three keys, a ball that flies, and a body that is visible
/// at the second key only.
MovingScene sample() {
  MovingScene moving;
  moving.times = {0, 1, 3};
  moving.scene.materials.resize(2);
  moving.scene.materials[0].name = "wood";
  moving.scene.materials[1].name = "ball";
  const auto add = [&](const char* component, double height, std::uint32_t material, MeshMotion motion) {
    MeshInstances& made = moving.scene.meshes.emplace_back();
    made.component = component;
    made.mesh = cylinder(height);
    made.material = material;
    made.frames = {Frame{}};
    moving.motions.push_back(std::move(motion));
  };
  add("trunk", 1, 0, {});
  add("trunk", 2, 0, {.kind = Kind::shape, .meshes = {cylinder(1e-4), cylinder(1.5), cylinder(2)}});
  const Frame gone{Mat3(0), Vec3(1, 0, 0)};
  const Frame high{Mat3(2), Vec3(1, 5, 0)};
  add("ball", 1, 1, {.kind = Kind::rigid, .frames = {{gone}, {{Mat3(1), Vec3(1, 2, 0)}}, {high}}});
  moving.scene.meshes.back().frames = {high};
  add("body", 1, 0, {.kind = Kind::shown, .shown_at = 1});
  return moving;
}

Glb written(const MovingScene& moving) {
  const TemporaryFolder folder;
  Progress progress;
  write_moving_glb(moving, folder / "plant.glb", {}, progress);
  return read_glb(folder / "plant.glb");
}

const Glb::Json* channel_of(const Glb& glb, const std::string& path) {
  for (const auto& channel : glb.json["animations"][0]["channels"]) {
    if (channel["target"]["path"] == path) return &channel;
  }
  return nullptr;
}

std::vector<float> outputs(const Glb& glb, const Glb::Json& channel) {
  const auto& sampler = glb.json["animations"][0]["samplers"][channel["sampler"].get<int>()];
  const auto& accessor = glb.accessor(sampler["output"]);
  const std::string data = glb.bytes_of(glb.view(accessor["bufferView"]));
  const std::size_t width = accessor["type"] == "VEC3" ? 3 : accessor["type"] == "VEC4" ? 4 : 1;
  std::vector<float> values(accessor["count"].get<std::size_t>() * width);
  std::memcpy(values.data(), data.data() + accessor.value("byteOffset", 0), values.size() * sizeof(float));
  return values;
}

TEST(MovingGlb, ShapesHaveATargetPerKeyButTheLast) {
  const Glb glb = written(sample());
  const auto moves = [](const Glb::Json& mesh) { return mesh.contains("weights"); };
  const auto& meshes = glb.json["meshes"];
  ASSERT_EQ(std::count_if(meshes.begin(), meshes.end(), moves), 1);
  const auto& primitive = (*std::find_if(meshes.begin(), meshes.end(), moves))["primitives"][0];
  ASSERT_EQ(primitive["targets"].size(), 2U);
  // The stem is 2 m high at the end. At the first key, all of its vertices are at the height of its base.
  const auto high = glb.values<Vec3>(glb.accessor(primitive, "POSITION"));
  const auto down = glb.values<Vec3>(glb.accessor(primitive["targets"][0]["POSITION"]));
  ASSERT_EQ(high.size(), down.size());
  for (std::size_t k = 0; k < high.size(); ++k) EXPECT_NEAR(high[k].y + down[k].y, 0, 2e-4);
  const auto* const weights = channel_of(glb, "weights");
  ASSERT_NE(weights, nullptr);
  EXPECT_EQ(outputs(glb, *weights), (std::vector<float>{1, 0, 0, 1, 0, 0}));
}

TEST(MovingGlb, RigidPartsAreNodesThatMove) {
  const Glb glb = written(sample());
  const auto* const shift = channel_of(glb, "translation");
  ASSERT_NE(shift, nullptr);
  EXPECT_EQ(outputs(glb, *shift), (std::vector<float>{1, 0, 0, 1, 2, 0, 1, 5, 0}));
  const auto& node = glb.json["nodes"][(*shift)["target"]["node"].get<int>()];
  EXPECT_FALSE(node.contains("matrix")) << "what moves has no matrix";
  EXPECT_EQ(node["scale"][0], 2);
  EXPECT_EQ(node["translation"][1], 5);
  EXPECT_EQ(channel_of(glb, "rotation"), nullptr) << "what does not turn has no channel";
}

TEST(MovingGlb, WhatIsShownForAWhileHasNoSizeAtOtherTimes) {
  const Glb glb = written(sample());
  for (const auto& channel : glb.json["animations"][0]["channels"]) {
    const auto& sampler = glb.json["animations"][0]["samplers"][channel["sampler"].get<int>()];
    if (sampler["interpolation"] != "STEP") continue;
    EXPECT_EQ(outputs(glb, channel), (std::vector<float>{0, 0, 0, 1, 1, 1, 0, 0, 0}));
    EXPECT_EQ(glb.json["nodes"][channel["target"]["node"].get<int>()]["scale"], (std::vector<int>{0, 0, 0}));
    return;
  }
  FAIL() << "no channel is stepped";
}

TEST(MovingGlb, TimesAreThoseOfTheKeys) {
  const Glb glb = written(sample());
  const auto& times = glb.accessor(glb.json["animations"][0]["samplers"][0]["input"]);
  EXPECT_EQ(times["count"], 3);
  EXPECT_EQ(times["min"][0], 0);
  EXPECT_EQ(times["max"][0], 3);
}

TEST(MovingGlb, ASceneThatStandsStillHasNoAnimation) {
  MovingScene moving = sample();
  moving.scene.meshes.resize(1);
  moving.motions.resize(1);
  const Glb glb = written(moving);
  EXPECT_FALSE(glb.json.contains("animations"));
  EXPECT_EQ(glb.json["meshes"].size(), 1U);
}

TEST(MovingGlb, ColoursMoveByTheirDifferences) {
  MovingScene moving = sample();
  moving.scene.meshes = {moving.scene.meshes[1]};
  moving.motions = {moving.motions[1]};
  moving.scene.materials[0].colour = Vec3(1);
  moving.scene.meshes[0].tints = {{0.5F, 0.5F, 0.5F}};
  moving.motions[0].tints = {{{0.25F, 0.5F, 0.5F}}, {{0.5F, 0.5F, 0.5F}}, {{0.5F, 0.5F, 0.5F}}};
  const Glb glb = written(moving);
  const auto& primitive = glb.json["meshes"][0]["primitives"][0];
  const auto changes = glb.values<Vec4>(glb.accessor(primitive["targets"][0]["COLOR_0"]));
  ASSERT_FALSE(changes.empty());
  EXPECT_NEAR(changes[0].r, -0.5F, 1e-5) << "half of the material's factor";
  EXPECT_EQ(changes[0].g, 0);
  EXPECT_EQ(changes[0].a, 0);
}

}  // namespace meristem::gltf_moving_test
