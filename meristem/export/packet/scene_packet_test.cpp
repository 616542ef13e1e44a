// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/packet/scene_packet.h"

#include <cmath>
#include <cstring>

#include <rapidcheck/gtest.h>

#include "meristem/base/random.h"
#include "meristem/output/picture/obstacle_meshes.h"
#include "tests/support/sample_plants.h"
#include "tests/support/sample_scenes.h"
#include "tests/support/shown_scene.h"

namespace meristem::scene_packet_test {

std::string next(PacketMaker& maker, const MeshScene& scene) {
  return maker.next({.meshes = &scene}, {.hash = "0"}, Progress());
}

ShownScene shown(const MeshScene& scene) {
  PacketMaker maker;
  ShownScene all;
  all.apply(next(maker, scene));
  return all;
}

template <class Number>
std::vector<Number> array(const ReadPacket& packet, const Value& part, std::string_view name) {
  const Value::List& place = *part.find(name)->list();
  std::vector<Number> numbers(static_cast<std::size_t>(*place[1].number()));
  if (numbers.empty()) return numbers;
  std::memcpy(numbers.data(), packet.arrays.data() + static_cast<std::size_t>(*place[0].number()),
              numbers.size() * sizeof(Number));
  return numbers;
}

TEST(ScenePacket, HoldsTheSceneInArraysOfItsNumbers) {
  MeshScene scene = scene_of(triangle_with_tangents(), {shifted({1, 2, 3}), mirror()});
  scene.materials[0].texture = plain_texture();
  scene.meshes[0].tints = {Vec3(0.5F, 1, 2), Vec3(0, 0.25F, 1)};
  PacketMaker maker;
  const std::string bytes = next(maker, scene);
  const ReadPacket packet(bytes);
  EXPECT_TRUE(packet.flag("whole"));
  EXPECT_EQ(packet.number("triangles"), 2);

  const Value& mesh = (*packet.head.find("meshes")->list())[0];
  EXPECT_EQ(array<float>(packet, mesh, "positions"), (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 2, 0}));
  EXPECT_EQ(array<std::int8_t>(packet, mesh, "normals"),
            (std::vector<std::int8_t>{0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0}));
  EXPECT_EQ(array<std::int8_t>(packet, mesh, "tangents"),
            (std::vector<std::int8_t>{127, 0, 0, 127, 127, 0, 0, 127, 127, 0, 0, 127}));
  EXPECT_EQ(array<std::uint16_t>(packet, mesh, "uvs"), (std::vector<std::uint16_t>{0, 0, 65535, 0, 16384, 65535}));
  EXPECT_EQ(array<std::uint16_t>(packet, mesh, "indices"), (std::vector<std::uint16_t>{0, 1, 2}));

  const Value& set = (*packet.head.find("instances_of")->list())[0];
  EXPECT_EQ(array<float>(packet, set, "frames"),
            (std::vector<float>{1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}));
  EXPECT_EQ(array<std::uint8_t>(packet, set, "tints"),
            (std::vector<std::uint8_t>{255, 255, 255, 255, 0, 64, 128, 255}));
  EXPECT_EQ(write_json_line(*set.find("tint_scale")), "[0.5, 1, 2]");

  const Value& material = (*packet.head.find("materials")->list())[0];
  EXPECT_EQ(packet.count("pictures"), 2U);
  const Value& picture = (*packet.head.find("pictures")->list())[0];
  EXPECT_EQ(*material.find("picture")->text(), *picture.find("key")->text());
  const std::vector<std::uint8_t> png = array<std::uint8_t>(packet, picture, "bytes");
  EXPECT_EQ(std::string(png.begin() + 1, png.begin() + 4), "PNG");
}

TEST(ScenePacket, GivesNormalsToMeshesThatHaveNone) {
  const MeshScene scene = scene_of(strip(1), {Frame()});
  PacketMaker maker;
  const std::string bytes = next(maker, scene);
  const ReadPacket packet(bytes);
  const auto normals = array<std::int8_t>(packet, (*packet.head.find("meshes")->list())[0], "normals");
  EXPECT_EQ(normals.size(), 12U);
  EXPECT_EQ(std::abs(normals[2]), 127);
}

TEST(ScenePacket, UsesWideNumbersWhereShortOnesDoNotDo) {
  Mesh mesh = *strip(70'000);
  mesh.uvs.assign(mesh.vertex_count(), Vec2(0.5F, -3));
  const MeshScene scene = scene_of(std::make_shared<const Mesh>(std::move(mesh)), {Frame()});
  PacketMaker maker;
  const std::string bytes = next(maker, scene);
  const ReadPacket packet(bytes);
  const Value& part = (*packet.head.find("meshes")->list())[0];
  EXPECT_EQ(*part.find("uv_type")->text(), "f32");
  EXPECT_EQ(array<float>(packet, part, "uvs")[1], -3);
  EXPECT_EQ(*part.find("index_type")->text(), "u32");
  EXPECT_EQ(array<std::uint32_t>(packet, part, "indices").back(), 70'000U);
}

TEST(ScenePacket, OfTheSameSceneIsEmpty) {
  const MeshScene scene = leafy_scene(10);
  PacketMaker maker;
  next(maker, scene);
  const std::string again = next(maker, scene);
  EXPECT_LT(again.size(), 300U);
  const ReadPacket packet(again);
  for (const char* list : {"pictures", "materials", "meshes", "instances_of", "batches", "lines"})
    EXPECT_EQ(packet.head.find(list), nullptr) << list;
  EXPECT_EQ(packet.head.find("gone"), nullptr);
}

TEST(ScenePacket, OfAnotherColourIsSmall) {
  MeshScene scene = leafy_scene(1000);
  PacketMaker maker;
  next(maker, scene);
  scene.materials[0].colour = {0.1F, 0.2F, 0.3F};
  const std::string bytes = next(maker, scene);
  EXPECT_LT(bytes.size(), 2000U);
  EXPECT_EQ(ReadPacket(bytes).count("materials"), 1U);
}

TEST(ScenePacket, IsWholeAgainForWhoHasForgotten) {
  const MeshScene scene = leafy_scene(10);
  PacketMaker maker;
  next(maker, scene);
  maker.forget();
  const std::string bytes = next(maker, scene);
  EXPECT_TRUE(ReadPacket(bytes).flag("whole"));
  ShownScene viewer;
  viewer.apply(bytes);
  EXPECT_EQ(viewer, shown(scene));
}

TEST(ScenePacket, LeavesTheViewersSceneWhereItIsCancelled) {
  const MeshScene one = leafy_scene(10);
  const MeshScene other = leafy_scene(20);
  PacketMaker maker;
  ShownScene viewer;
  viewer.apply(next(maker, one));
  Progress stopped;
  stopped.cancel();
  EXPECT_THROW(maker.next({.meshes = &other}, {}, stopped), Cancelled);
  viewer.apply(next(maker, other));
  EXPECT_EQ(viewer, shown(other));
}

TEST(ScenePacket, DrawsTheThickestOfTooManySegments) {
  const Plant plant = two_stems();
  PacketMaker maker;
  const auto segments = [&](std::size_t max) {
    const std::string bytes = maker.next({.skeletons = &plant, .max_segments = max}, {}, Progress());
    const ReadPacket packet(bytes);
    std::size_t count = 0;
    for (const Value& part : *packet.head.find("skeletons")->list()) {
      count += array<std::uint32_t>(packet, part, "segments").size() / 2;
    }
    return count;
  };
  EXPECT_EQ(segments(0), 5U);  // three segments of the fork, two of the rod
  EXPECT_LE(segments(3), 3U);
}

TEST(ScenePacket, LeavesTheViewerWhatDraftsDoNotShow) {
  const MeshScene scene = leafy_scene(100);
  const MeshScene draft = scene_of(strip(3), {Frame()});
  PacketMaker maker;
  ShownScene viewer;
  viewer.apply(next(maker, scene));
  viewer.apply(maker.next({.meshes = &draft}, {.is_draft = true}, Progress()));
  EXPECT_EQ(viewer.batch_count(), 1U);
  const std::string bytes = next(maker, scene);
  EXPECT_EQ(ReadPacket(bytes).count("meshes"), 0U);
  EXPECT_EQ(ReadPacket(bytes).count("instances_of"), 0U);
  viewer.apply(bytes);
  EXPECT_EQ(viewer, shown(scene));
}

/// Makes a random change, as any edit could.
void change(MeshScene& scene, const RandomKey& key) {
  const auto chosen = [&](std::uint64_t index, std::size_t count) {
    return static_cast<std::size_t>(key.uniform(index, 0, static_cast<double>(count)));
  };
  const std::size_t batch = scene.meshes.empty() ? 0 : chosen(0, scene.meshes.size());
  const std::size_t what = scene.meshes.empty() ? 6 : chosen(1, 9);
  switch (what) {
    case 0:
      scene.materials[chosen(2, scene.materials.size())].colour = Vec3(static_cast<float>(key.uniform(3)));
      break;
    case 1:
      scene.materials[chosen(2, scene.materials.size())].texture = chosen(3, 2) == 0 ? plain_texture() : nullptr;
      break;
    case 2:
      scene.meshes[batch].mesh = strip(static_cast<std::uint32_t>(1 + chosen(2, 4)));
      break;
    case 3:
      scene.meshes[batch].frames.push_back(shifted(Vec3(static_cast<float>(chosen(2, 3)))));
      scene.meshes[batch].tints.clear();
      break;
    case 4:
      scene.meshes[batch].tints.assign(scene.meshes[batch].frames.size(), Vec3(static_cast<float>(key.uniform(2))));
      break;
    case 5:
      scene.meshes.erase(scene.meshes.begin() + static_cast<std::ptrdiff_t>(batch));
      break;
    case 6:
      scene.meshes.push_back({chosen(2, 2) == 0 ? "leaf" : "bud", triangle(), 0, {Frame()}, {}});
      break;
    case 7:
      scene.materials.push_back(scene.materials[0]);
      scene.meshes[batch].material = static_cast<std::uint32_t>(scene.materials.size() - 1);
      break;
    default:
      for (MeshInstances& instances : scene.meshes) instances.material = 0;
      scene.materials.resize(1);
  }
}

RC_GTEST_PROP(ScenePacket, TakenInTurnAreTheLastSceneInFull, (std::uint64_t seed)) {
  const RandomKey key(seed);
  MeshScene scene = leafy_scene(5);
  PacketMaker maker;
  ShownScene viewer;
  viewer.apply(next(maker, scene));
  for (std::uint64_t step = 0; step < 20; ++step) {
    const auto changes = static_cast<std::uint64_t>(key.uniform(step, 0, 4));
    for (std::uint64_t k = 0; k < changes; ++k) change(scene, key.child(step).child(k));
    viewer.apply(next(maker, scene));
    RC_ASSERT(viewer == shown(scene));
  }
}

TEST(ScenePacket, HasTheSameBytesForTheSameScenes) {
  PacketMaker one;
  PacketMaker other;
  for (const std::size_t leaves : {3U, 7U}) EXPECT_EQ(next(one, leafy_scene(leaves)), next(other, leafy_scene(leaves)));
}

TEST(ScenePacket, ObstaclesStandBehindThePlantsAndDoNotCount) {
  const MeshScene plants = scene_of(triangle(), {Frame()});
  Progress progress;
  const Obstacles wall({{.mesh = box_mesh({-4, 0, -3}, {4, 6, -2}), .colour = {0.9F, 0.1F, 0.1F}}});
  const MeshScene bodies = obstacle_meshes(wall, progress);
  PacketMaker maker;
  const ReadPacket both(maker.next({.meshes = &plants, .obstacles = &bodies}, {.hash = "0"}, progress));
  EXPECT_EQ(both.number("triangles"), 1);
  const Value& batches = *both.head.find("batches");
  ASSERT_EQ(batches.list()->size(), 2U);
  const Value& wall_batch = (*batches.list())[1];
  EXPECT_EQ(*wall_batch.find("component")->text(), "scene.obstacles[0]");
  EXPECT_EQ(*wall_batch.find("material")->number(), static_cast<double>(plants.materials.size()));
  // The bounds are those around the plant.
  const ReadPacket alone(PacketMaker().next({.meshes = &plants}, {.hash = "0"}, progress));
  EXPECT_EQ(*both.head.find("bounds"), *alone.head.find("bounds"));
  // The obstacles disappear if they are not sent again.
  const ReadPacket without(maker.next({.meshes = &plants}, {.hash = "1"}, progress));
  EXPECT_EQ(without.head.find("gone")->find("batches")->list()->size(), 1U);
}

TEST(ScenePacket, TellsOfASceneOnceAndAgainWhenItChanges) {
  Scene scene;
  scene.sun = {kPi / 2, 0};
  scene.light.lamps = {{.position = {1, 2, 3}, .strength = 0.5}};
  scene.supports = {{"wire", {Vec3(-1, 1, 0), Vec3(1, 1, 0)}}};
  Progress progress;
  PacketMaker maker;
  const std::string packet = maker.next({.scene = &scene}, {.hash = "0"}, progress);
  const ReadPacket first(packet);
  const Value& told = *first.head.find("scene");
  EXPECT_EQ(*(*told.find("lamps")->list())[0].find("strength")->number(), 0.5);
  const Value& wire = (*told.find("supports")->list())[0];
  EXPECT_EQ(*wire.find("name")->text(), "wire");
  EXPECT_EQ(array<float>(first, wire, "points"), (std::vector<float>{-1, 1, 0, 1, 1, 0}));
  EXPECT_NEAR(*(*told.find("sun")->list())[0].number(), 1, 1e-6);
  EXPECT_EQ(ReadPacket(maker.next({.scene = &scene}, {.hash = "0"}, progress)).head.find("scene"), nullptr);
  scene.light.lamps[0].strength = 1;
  EXPECT_NE(ReadPacket(maker.next({.scene = &scene}, {.hash = "0"}, progress)).head.find("scene"), nullptr);
}

}  // namespace meristem::scene_packet_test
