// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/obstacle_meshes.h"

#include <gtest/gtest.h>

#include "meristem/output/picture/still.h"
#include "tests/support/sample_scenes.h"

namespace meristem::obstacle_meshes_test {

Obstacles wall_and_hidden_box() {
  return Obstacles({{.mesh = box_mesh({-4, 0, -3}, {4, 6, -2}), .colour = {0.9F, 0.1F, 0.1F}},
                    {.mesh = box_mesh({2, 0, 2}, {3, 3, 3}), .is_hidden = true}});
}

Image picture(const MeshScene& meshes, const Scene& scene, StillOptions options = {}) {
  options.width = options.height = 64;
  options.samples = 16;
  Progress progress;
  return render_still(meshes, scene, {}, options, progress);
}

TEST(ObstacleMeshes, FollowThePlantsWithTheirColours) {
  const MeshScene plants = scene_of(triangle(), {Frame()});
  const MeshScene all = with_obstacles(plants, wall_and_hidden_box());
  ASSERT_EQ(all.meshes.size(), 2U);
  EXPECT_EQ(all.meshes[0].mesh, plants.meshes[0].mesh);
  EXPECT_EQ(all.materials[all.meshes[1].material].colour, Vec3(0.9F, 0.1F, 0.1F));
  EXPECT_EQ(all.meshes[1].triangle_count(), 12U);
  Box box;
  for (const Vec3 position : all.meshes[1].mesh->positions) box.add(all.meshes[1].frames[0].point(position));
  EXPECT_EQ(box.low, Vec3(-4, 0, -3));
  EXPECT_EQ(box.high, Vec3(4, 6, -2));
  EXPECT_TRUE(has_visible(wall_and_hidden_box()));
  EXPECT_FALSE(has_visible(Obstacles()));
}

TEST(ObstacleMeshes, AloneTheyAreCalledByTheirPathsAndAreFlat) {
  Progress progress;
  Obstacles obstacles({{.mesh = box_mesh({2, 0, 2}, {3, 3, 3}), .is_hidden = true},
                       {.mesh = box_mesh({-4, 0, -3}, {4, 6, -2}), .colour = {0.9F, 0.1F, 0.1F}}});
  const MeshScene alone = obstacle_meshes(obstacles, progress);
  ASSERT_EQ(alone.meshes.size(), 1U);
  EXPECT_EQ(alone.meshes[0].component, "scene.obstacles[1]");
  EXPECT_EQ(alone.materials[0].colour, Vec3(0.9F, 0.1F, 0.1F));
  for (const Vec3 normal : alone.meshes[0].mesh->normals)
    EXPECT_FLOAT_EQ(std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z), 1);
}

TEST(ObstacleMeshes, StandBehindThePlantInPictures) {
  const MeshScene plants = scene_of(triangle(), {Frame()});
  Scene scene;
  scene.sun = {kPi, 0.6};
  const Image without = picture(plants, scene);
  scene.obstacles = wall_and_hidden_box();
  const Image with = picture(plants, scene);
  // The upper corners, which showed the sky, are red now. The plant has not moved.
  const auto red = [](const Image& image, std::size_t pixel) {
    return image.rgba[4 * pixel] - image.rgba[4 * pixel + 2];
  };
  EXPECT_LT(red(without, 3 * 64 + 60), 0);
  EXPECT_GT(red(with, 3 * 64 + 60), 60);
  const StillOptions transparent{.transparent = true};
  EXPECT_EQ(picture(plants, scene, transparent).rgba, picture(plants, Scene{.sun = scene.sun}, transparent).rgba);
}

TEST(ObstacleMeshes, AloneTheyAreFramed) {
  Scene scene;
  scene.obstacles = Obstacles({{.mesh = box_mesh({100, 0, 100}, {140, 30, 140}), .colour = {1, 0, 0}}});
  const Image image = picture(MeshScene(), scene);
  const std::size_t middle = 32 * 64 + 32;
  EXPECT_GT(image.rgba[4 * middle] - image.rgba[4 * middle + 2], 60);
}

}  // namespace meristem::obstacle_meshes_test
