// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/camera.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::camera_test {

/// Returns small meshes at scattered positions, some of them mirrored or scaled.
MeshScene specks(int count, Vec3 spread) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0.05F}};
  mesh.triangles = {{0, 1, 2}};
  MeshScene scene;
  scene.materials.emplace_back();
  scene.meshes = {{"speck", std::make_shared<const Mesh>(mesh), 0, {}}};
  const RandomKey key(9);
  for (int i = 0; i < count; ++i) {
    scene.meshes[0].frames.push_back(frame_along(spread * key.direction(i), key.direction(i + 1000), kUp));
  }
  return scene;
}

float farthest_from_middle(const MeshScene& scene, const Camera& camera) {
  float farthest = 0;
  for (const Frame& frame : scene.meshes[0].frames) {
    for (const Vec3 position : scene.meshes[0].mesh->positions) {
      const std::optional<Vec2> film = camera.project(frame.point(position));
      if (!film) return 1e9F;
      farthest = std::max({farthest, std::abs(film->x), std::abs(film->y)});
    }
  }
  return farthest;
}

TEST(Camera, ProjectUndoesDirection) {
  const Camera camera({1, 2, 3}, {0, 1, 0}, 0.7, 1.5);
  for (const Vec2 film : {Vec2(0, 0), Vec2(1, -1), Vec2(-0.3F, 0.8F)}) {
    const auto seen = camera.project(camera.position() + 5.0F * camera.direction(film));
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->x, film.x, 1e-5);
    EXPECT_NEAR(seen->y, film.y, 1e-5);
  }
  EXPECT_FALSE(camera.project(camera.position() - camera.direction({0, 0})));
}

TEST(Camera, UpIsUpAndRightIsRight) {
  const Camera camera({0, 0, 5}, {0, 0, 0}, 0.7, 1);
  EXPECT_GT(camera.project({0, 1, 0})->y, 0);
  EXPECT_GT(camera.project({1, 0, 0})->x, 0);
}

TEST(Camera, FramesEverythingTightlyFromAnyDirection) {
  for (const Vec3 spread : {Vec3(3, 3, 3), Vec3(0.5F, 10, 0.5F), Vec3(10, 0.1F, 10)}) {
    const MeshScene scene = specks(300, spread);
    for (const double azimuth : {0.0, 1.0, 2.6, 5.0}) {
      for (const double altitude : {-0.3, 0.12, 1.0, kPi / 2}) {
        for (const double aspect : {0.5, 1.0, 2.0}) {
          CameraView view;
          view.azimuth = azimuth;
          view.altitude = altitude;
          const float farthest = farthest_from_middle(scene, place_camera(scene, view, aspect));
          EXPECT_LT(farthest, 1);
          EXPECT_GT(farthest, 0.8F);
        }
      }
    }
  }
}

TEST(Camera, SeesEverythingWithAGivenTarget) {
  const MeshScene scene = specks(300, Vec3(2));
  CameraView view;
  view.target = Vec3(1, 1, 0);
  const Camera camera = place_camera(scene, view, 1);
  EXPECT_LT(farthest_from_middle(scene, camera), 1);
  EXPECT_NEAR(glm::length(*camera.project(*view.target)), 0, 1e-5);
}

TEST(Camera, StandsWhereItIsTold) {
  CameraView view;
  view.position = Vec3(7, 8, 9);
  view.target = Vec3(1, 2, 3);
  const Camera camera = place_camera(specks(3, Vec3(1)), view, 1);
  EXPECT_EQ(camera.position(), *view.position);
  EXPECT_NEAR(glm::dot(camera.direction({0, 0}), glm::normalize(*view.target - *view.position)), 1, 1e-6);
}

TEST(Camera, APlacedViewStaysWhileThePlantGrows) {
  const MeshScene large = specks(300, Vec3(3));
  for (const std::optional<Vec3> target : {std::optional<Vec3>(), std::optional<Vec3>(Vec3(0, 1, 0))}) {
    CameraView view;
    view.target = target;
    const Camera expected = place_camera(large, view, 1.5);
    const Camera later = place_camera(specks(10, Vec3(1)), placed_view(large, view, 1.5), 1.5);
    EXPECT_EQ(later.position(), expected.position());
    EXPECT_LT(glm::distance(later.direction({0.7F, -0.4F}), expected.direction({0.7F, -0.4F})), 1e-5);
  }
}

TEST(Camera, AzimuthSaysWhereItStands) {
  CameraView view;
  view.azimuth = radians(90);
  view.altitude = 0;
  const Camera camera = place_camera(specks(100, Vec3(1)), view, 1);
  EXPECT_GT(camera.position().x, 2);  // in the east
  EXPECT_NEAR(camera.direction({0, 0}).x, -1, 1e-5);
}

TEST(Camera, FindsAPlaceForAnEmptyScene) {
  const Camera camera = place_camera(MeshScene(), CameraView(), 1);
  EXPECT_TRUE(std::isfinite(glm::length(camera.position())));
  EXPECT_NEAR(glm::length(*camera.project(Vec3(0))), 0, 0.2);
}

TEST(Camera, RollTurnsThePictureClockwise) {
  const Camera level({0, 0, 5}, {0, 0, 0}, 0.7, 1);
  const Camera rolled({0, 0, 5}, {0, 0, 0}, 0.7, 1, kPi / 2);
  const Vec2 top = *level.project({0, 1, 0});
  EXPECT_NEAR(rolled.project({0, 1, 0})->x, top.y, 1e-5) << "what was above is to the right";
  EXPECT_NEAR(rolled.project({0, 1, 0})->y, 0, 1e-5);
  EXPECT_EQ(rolled.forward(), level.forward());
}

TEST(Camera, ARolledCameraFramesEverythingTightly) {
  const MeshScene scene = specks(300, {0.5F, 10, 0.5F});
  for (const double roll : {0.4, 1.5, -2.0}) {
    CameraView view;
    view.roll = roll;
    EXPECT_NEAR(farthest_from_middle(scene, place_camera(scene, view, 1.5)), 0.93, 0.02) << roll;
  }
}

}  // namespace meristem::camera_test
