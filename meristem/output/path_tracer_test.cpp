// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/path_tracer.h"

#include <cmath>

#include <gtest/gtest.h>

namespace meristem {
namespace {

constexpr int kSamples = 4096;

Mesh square(float half) {
  Mesh mesh;
  mesh.positions = {{-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A level square of 2 m at the origin.
MeshScene level_square(Material material) {
  MeshScene scene;
  scene.materials = {std::move(material)};
  scene.meshes = {{"square", std::make_shared<const Mesh>(square(1)), 0, {Frame()}}};
  return scene;
}

Material white() {
  Material material;
  material.colour = Vec3(1);
  return material;
}

Daylight uniform_light(Vec3 radiance) {
  return {[&](Vec3) { return radiance; }, radiance};
}

/// The mean over paths that start along one ray.
Seen mean_seen(const MeshScene& scene, const Daylight& light, std::optional<Ground> ground, const Ray& ray) {
  Progress progress;
  const RayScene rays(scene, progress);
  const PathTracer tracer(scene, rays, light, ground);
  DVec3 sum(0);
  double cover = 0;
  for (std::uint32_t s = 0; s < kSamples; ++s) {
    SampleStream samples(7, s, kSamples);
    const Seen seen = tracer.trace(ray, samples);
    sum += DVec3(seen.light);
    cover += seen.cover;
  }
  return {Vec3(sum / double{kSamples}), static_cast<float>(cover / kSamples)};
}

const Ray kFromAbove{{0.2F, 2, 0.3F}, {0, -1, 0}};
const Ray kFromBelow{{0.2F, -2, 0.3F}, {0, 1, 0}};

TEST(PathTracer, AWhitePlaneUnderAUniformSkyIsAsBrightAsTheSky) {
  const Seen seen = mean_seen(level_square(white()), uniform_light({0.5F, 1, 2}), std::nullopt, kFromAbove);
  EXPECT_EQ(seen.cover, 1);
  EXPECT_NEAR(seen.light.r, 0.5, 1e-4);
  EXPECT_NEAR(seen.light.g, 1, 1e-4);
  EXPECT_NEAR(seen.light.b, 2, 1e-4);
}

TEST(PathTracer, AGreyPlaneGivesBackItsShare) {
  Material grey = white();
  grey.colour = Vec3(0.5F);
  const Seen seen = mean_seen(level_square(grey), uniform_light(Vec3(1)), std::nullopt, kFromAbove);
  EXPECT_NEAR(seen.light.g, 0.21404, 1e-4);
}

TEST(PathTracer, WhiteGroundUnderAUniformSkyIsAsBrightAsTheSky) {
  Ground ground;
  ground.colour = Vec3(1);
  ground.fade_distance = 1e6F;
  const Ray ray{{50, 1, 50}, glm::normalize(Vec3(1, -1, 0))};
  const Seen seen = mean_seen(level_square(white()), uniform_light(Vec3(1)), ground, ray);
  EXPECT_NEAR(seen.light.g, 1, 1e-3);
}

TEST(PathTracer, GroundFadesWithDistance) {
  Ground ground;
  ground.fade_distance = 10;
  const auto cover_at = [&](float distance) {
    const Ray ray{{distance, 1, 0}, {0, -1, 0}};
    return mean_seen(level_square(white()), uniform_light(Vec3(1)), ground, ray).cover;
  };
  EXPECT_NEAR(cover_at(10), 0.5, 1e-5);
  EXPECT_GT(cover_at(2), 0.98F);
  EXPECT_LT(cover_at(100), 0.01F);
}

TEST(PathTracer, TheSunLightsWithTheCosine) {
  Material matt = white();
  matt.roughness = 1;
  const Sky sky({radians(90), radians(30)});
  const Daylight light(sky, Vec3(0));
  const Seen lit = mean_seen(level_square(matt), light, std::nullopt, kFromAbove);
  const Vec3 expected = (0.5F * sky.sun_irradiance() + sky.dome_irradiance()) / static_cast<float>(kPi);
  EXPECT_NEAR(lit.light.g, expected.g, 0.03 * expected.g);  // wax adds a little gloss
}

TEST(PathTracer, TheShadowOfARoofLiesWhereTheSunPutsIt) {
  // A roof 1 m up; the sun in the east at 45° moves its shadow 1 m to the west.
  MeshScene scene = level_square(white());
  scene.meshes[0].frames[0].origin.y = 1;
  Ground ground;
  ground.colour = Vec3(0.5F);
  const Sky sky({radians(90), radians(45)});
  const Daylight light(sky, Vec3(0));
  const auto brightness = [&](float x) {
    const Ray ray{{x, 0.5F, 0}, {0, -1, 0}};
    return mean_seen(scene, light, ground, ray).light.g;
  };
  const float sun = 0.5F * std::sqrt(0.5F) * sky.sun_irradiance().g / static_cast<float>(kPi);
  EXPECT_LT(brightness(-1.9F), 0.5F * sun);
  EXPECT_LT(brightness(-0.1F), 0.5F * sun);
  EXPECT_GT(brightness(-2.1F), sun);
  EXPECT_GT(brightness(0.1F), sun);
}

TEST(PathTracer, AThinBladeShinesThroughAndWoodDoesNot) {
  Material leaf = white();
  leaf.colour = Vec3(0.6F);
  leaf.two_sided = true;
  leaf.translucency = 0.5F;
  const Daylight light(Sky({0, radians(80)}), Vec3(0));
  EXPECT_GT(mean_seen(level_square(leaf), light, std::nullopt, kFromBelow).light.g, 0.05F);
  leaf.translucency = 0;
  EXPECT_LT(mean_seen(level_square(leaf), light, std::nullopt, kFromBelow).light.g, 1e-4F);
}

TEST(PathTracer, NoSurfaceGivesBackMoreLightThanItGets) {
  Material leaf = white();
  leaf.two_sided = true;
  leaf.translucency = 0.5F;
  const Seen seen = mean_seen(level_square(leaf), uniform_light(Vec3(1)), std::nullopt, kFromAbove);
  EXPECT_LE(seen.light.g, 1.001F);
}

TEST(Daylight, TabulatedDomeIsTheSky) {
  const Sky sky({radians(200), radians(35)});
  const Daylight light(sky, Vec3(0.2F));
  for (int azimuth_deg = 0; azimuth_deg < 360; azimuth_deg += 20) {
    for (const int altitude_deg : {0, 5, 20, 60, 88}) {
      const Vec3 direction = unit_vector({radians(azimuth_deg), radians(altitude_deg)});
      const Vec3 expected = sky.radiance(direction);
      EXPECT_LT(glm::distance(light.seen(direction), expected), 0.03F * glm::length(expected))
          << azimuth_deg << ' ' << altitude_deg;
    }
  }
}

TEST(RayScene, InstancesAndCopiesAnswerAlike) {
  const auto mesh = std::make_shared<const Mesh>(square(0.3F));
  std::vector<Frame> frames;
  for (int i = 0; i < 1200; ++i) {
    const float at = static_cast<float>(i);
    frames.push_back(frame_along({std::fmod(at, 40), 0.1F * at, at / 40}, glm::normalize(Vec3(1, at / 500, 0)), kUp));
  }
  MeshScene scene;
  scene.materials.emplace_back();
  scene.meshes = {{"leaf", mesh, 0, frames}};
  Progress progress;
  const RayScene copies(scene, progress);
  const RayScene instances(scene, progress, 0);
  int hits = 0;
  for (int i = 0; i < 1200; ++i) {
    const Vec3 target = frames[i].point({0.1F, 0, 0.05F});
    const Ray ray{target + Vec3(0.5F, 300, 0.2F), glm::normalize(-Vec3(0.5F, 300, 0.2F))};
    const auto a = copies.first_hit(ray);
    const auto b = instances.first_hit(ray);
    ASSERT_EQ(a.has_value(), b.has_value());
    EXPECT_EQ(copies.is_blocked(ray), instances.is_blocked(ray));
    if (!a) continue;
    ++hits;
    EXPECT_EQ(a->instance, b->instance);
    EXPECT_EQ(a->triangle, b->triangle);
    EXPECT_LT(glm::distance(copies.surface_point(*a).position, instances.surface_point(*b).position), 1e-3F);
  }
  EXPECT_GT(hits, 1000);
}

TEST(RayScene, NormalsFaceOutwardOnMirroredInstances) {
  Frame mirrored;
  mirrored.axes[0].x = -1;
  MeshScene scene = level_square(white());
  scene.meshes[0].frames = {mirrored};
  Progress progress;
  const RayScene rays(scene, progress);
  const auto hit = rays.first_hit(kFromAbove);
  ASSERT_TRUE(hit);
  EXPECT_GT(rays.surface_point(*hit).face_normal.y, 0.99F);
}

TEST(RayScene, StopsBuildingWhenCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(RayScene(level_square(white()), progress), Cancelled);
}

}  // namespace
}  // namespace meristem
