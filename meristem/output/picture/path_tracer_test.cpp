// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/path_tracer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/colour.h"

namespace meristem::path_tracer_test {

constexpr int kSamples = 4096;

Mesh square(float half) {
  Mesh mesh;
  mesh.positions = {{-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// Returns a level square of 2 m at the origin.
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

struct MeanSeen {
  Vec3 light;
  float cover;
};

/// Returns the mean over paths that start along one ray.
MeanSeen mean_seen(const MeshScene& scene, const Daylight& light, std::optional<Ground> ground, const Ray& ray,
                   const Lamplight& lamps = Lamplight()) {
  Progress progress;
  const RayScene rays(scene, progress);
  const PathTracer tracer(scene, rays, light, ground, lamps);
  DVec3 sum(0);
  double cover = 0;
  for (std::uint32_t s = 0; s < kSamples; ++s) {
    SampleStream samples(7, s, kSamples);
    const Seen seen = tracer.trace(ray, samples);
    sum += DVec3(seen.light());
    cover += seen.cover;
  }
  return {Vec3(sum / double{kSamples}), static_cast<float>(cover / kSamples)};
}

const Ray kFromAbove{{0.2F, 2, 0.3F}, {0, -1, 0}};
const Ray kFromBelow{{0.2F, -2, 0.3F}, {0, 1, 0}};

TEST(PathTracer, AWhitePlaneUnderAUniformSkyIsAsBrightAsTheSky) {
  const MeanSeen seen = mean_seen(level_square(white()), uniform_light({0.5F, 1, 2}), std::nullopt, kFromAbove);
  EXPECT_EQ(seen.cover, 1);
  EXPECT_NEAR(seen.light.r, 0.5, 1e-4);
  EXPECT_NEAR(seen.light.g, 1, 1e-4);
  EXPECT_NEAR(seen.light.b, 2, 1e-4);
}

TEST(PathTracer, IndirectLightIsTheAlbedoTimesWhatFalls) {
  Material leaf = white();
  leaf.colour = {0.5F, 0.8F, 0.4F};
  leaf.two_sided = true;
  leaf.translucency = 0.3F;
  leaf.roughness = 1;
  const MeshScene scene = level_square(leaf);
  Progress progress;
  const RayScene rays(scene, progress);
  const PathTracer tracer(scene, rays, uniform_light({0.5F, 1, 2}), std::nullopt);
  DVec3 indirect(0);
  Vec3 albedo(0);
  for (std::uint32_t s = 0; s < kSamples; ++s) {
    SampleStream samples(7, s, kSamples);
    const Seen seen = tracer.trace(kFromAbove, samples);
    ASSERT_EQ(seen.direct, Vec3(0));
    ASSERT_EQ(seen.sight, Sight::surface);
    ASSERT_FLOAT_EQ(seen.distance, 2);
    ASSERT_EQ(seen.normal, kUp);
    indirect += DVec3(seen.indirect);
    albedo = seen.albedo;
  }
  indirect /= kSamples;
  EXPECT_GT(albedo.g, albedo.r);
  EXPECT_NEAR(indirect.r, 0.5 * albedo.r, 0.02 * indirect.r);
  EXPECT_NEAR(indirect.g, albedo.g, 0.02 * indirect.g);
  EXPECT_NEAR(indirect.b, 2 * albedo.b, 0.02 * indirect.b);
}

TEST(PathTracer, TheSunIsDirectLight) {
  const MeshScene scene = level_square(white());
  Progress progress;
  const RayScene rays(scene, progress);
  const Sky sky({radians(90), radians(30)});
  const PathTracer tracer(scene, rays, Daylight(sky, Vec3(0)), std::nullopt);
  SampleStream samples(7, 0, 1);
  const Seen seen = tracer.trace(kFromAbove, samples);
  EXPECT_GT(seen.direct.g, 0.15F * sky.sun_irradiance().g);
  SampleStream past(7, 0, 1);
  const Seen nothing = tracer.trace({{5, 2, 0}, {0, -1, 0}}, past);
  EXPECT_EQ(nothing.sight, Sight::nothing);
  EXPECT_EQ(nothing.light(), Vec3(0));
}

TEST(PathTracer, AGreyPlaneGivesBackItsShare) {
  Material grey = white();
  grey.colour = Vec3(0.5F);
  const MeanSeen seen = mean_seen(level_square(grey), uniform_light(Vec3(1)), std::nullopt, kFromAbove);
  EXPECT_NEAR(seen.light.g, 0.21404, 1e-4);
}

TEST(PathTracer, WhiteGroundUnderAUniformSkyIsAsBrightAsTheSky) {
  Ground ground;
  ground.colour = Vec3(1);
  ground.fade_distance = 1e6F;
  const Ray ray{{50, 1, 50}, glm::normalize(Vec3(1, -1, 0))};
  const MeanSeen seen = mean_seen(level_square(white()), uniform_light(Vec3(1)), ground, ray);
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
  const MeanSeen lit = mean_seen(level_square(matt), light, std::nullopt, kFromAbove);
  const Vec3 expected = (0.5F * sky.sun_irradiance() + sky.dome_irradiance()) / static_cast<float>(kPi);
  EXPECT_NEAR(lit.light.g, expected.g, 0.03 * expected.g);  // wax adds a little gloss
}

TEST(PathTracer, TheShadowOfARoofLiesWhereTheSunPutsIt) {
  // A roof 1 m above. The sun in the east at 45° moves its shadow 1 m to the west.
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

TEST(PathTracer, LampsLightWithTheCosineAndTheSquareOfTheDistance) {
  Material matt = white();
  matt.colour = Vec3(0.5F);
  matt.roughness = 1;
  const Lamplight lamps({{.position = {0, 2, 0}, .strength = 0.5}});
  const MeshScene square = level_square(matt);
  const auto light_at = [&](float x) {
    const Ray ray{{x, 1, 0}, {0, -1, 0}};
    return mean_seen(square, uniform_light(Vec3(0)), std::nullopt, ray, lamps).light.g;
  };
  const float expected = linear_from_srgb(Vec3(0.5F)).g * lamps.irradiance(Vec3(0)).g / static_cast<float>(kPi);
  EXPECT_NEAR(light_at(0), expected, 0.1 * expected);  // with a little gloss
  const float squared = 1 + 0.9F * 0.9F / 4;  // squared distance relative to 2 m; the cosine is the inverse of its root
  EXPECT_NEAR(light_at(0.9F), light_at(0) / (squared * std::sqrt(squared)), 0.05 * expected);
}

TEST(PathTracer, ARoofShadesItsLampAndNothingBeyond) {
  MeshScene scene = level_square(white());
  scene.meshes[0].frames[0].origin.y = 1;
  Ground ground;
  ground.colour = Vec3(0.5F);
  const Ray onto_ground{{0, 0.5F, 0}, {0, -1, 0}};
  const auto brightness = [&](float height) {
    return mean_seen(scene, uniform_light(Vec3(0)), ground, onto_ground, Lamplight({{.position = {0, height, 0}}}))
        .light.g;
  };
  EXPECT_LT(brightness(2), 0.002F) << "the roof is between, and the ground around it far";
  EXPECT_GT(brightness(0.7F), 0.5F) << "the roof is beyond";
}

TEST(PathTracer, ManyLampsLightAsMuchAsOneInTheirPlace) {
  const std::vector<Lamp> many(5, Lamp{.position = {0.3F, 2, 0.2F}, .strength = 0.2});
  const MeanSeen one = mean_seen(level_square(white()), uniform_light(Vec3(0)), std::nullopt, kFromAbove,
                                 Lamplight({{.position = {0.3F, 2, 0.2F}, .strength = 1}}));
  const MeanSeen five =
      mean_seen(level_square(white()), uniform_light(Vec3(0)), std::nullopt, kFromAbove, Lamplight(many));
  EXPECT_GT(one.light.g, 0.1F);
  EXPECT_NEAR(five.light.g, one.light.g, 0.01 * one.light.g);
}

/// Returns a ball of radius 1 of few triangles, with smooth normals.
MeshScene smooth_ball(Material material, int around) {
  Mesh mesh;
  for (int row = 0; row <= around / 2; ++row) {
    for (int k = 0; k <= around; ++k) {
      const double polar = kPi * row / (around / 2), azimuth = 2 * kPi * k / around;
      mesh.positions.emplace_back(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                  std::sin(polar) * std::cos(azimuth));
    }
  }
  mesh.normals = mesh.positions;
  const auto stride = static_cast<std::uint32_t>(around + 1);
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(around / 2); ++row) {
    for (std::uint32_t k = 0; k + 1 < stride; ++k) {
      const std::uint32_t a = row * stride + k, b = a + stride;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  }
  MeshScene scene = level_square(std::move(material));
  scene.meshes[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  return scene;
}

// A triangle that faces away from a lamp is lit where the smooth ball would be.
TEST(PathTracer, TheShadowEdgeOfASmoothBallHasNoSteps) {
  Material matt = white();
  matt.roughness = 1;
  const MeshScene ball = smooth_ball(matt, 24);
  // The shadow's edge is at an azimuth of 11°. The faces around it, from 0° to 15°, face away from the lamp.
  const auto edge = static_cast<float>(radians(11));
  const Vec3 to_lamp(std::cos(edge), 0, -std::sin(edge));
  const Lamplight lamps({{.position = 1000.0F * to_lamp, .strength = 1e6}});
  const Daylight dark = uniform_light(Vec3(0));
  Progress progress;
  const RayScene rays(ball, progress);
  int checked = 0;
  for (int k = 0; k < 40; ++k) {
    const double azimuth = radians(11.5 + 3 * k / 40.0);
    const double height = 0.13 * (k % 5);
    const Ray ray{{std::sqrt(1 - height * height) * std::sin(azimuth), height, 3}, {0, 0, -1}};
    const std::optional<RayHit> hit = rays.first_hit(ray);
    ASSERT_TRUE(hit);
    const SurfacePoint point = rays.surface_point(*hit);
    const float cosine = glm::dot(point.normal, to_lamp);
    if (glm::dot(point.face_normal, to_lamp) > 0 || cosine < 0.005F) continue;
    ++checked;
    const float expected = cosine * lamps.irradiance(Vec3(0)).g / static_cast<float>(kPi);
    EXPECT_GE(mean_seen(ball, dark, std::nullopt, ray, lamps).light.g, 0.7F * expected) << degrees(azimuth);
  }
  EXPECT_GT(checked, 20);
}

TEST(PathTracer, ALowerOpacityShowsWhatLiesBehind) {
  Material glass = white();
  glass.opacity = 0.25F;
  MeshScene scene = level_square(glass);
  const MeanSeen alone = mean_seen(scene, uniform_light(Vec3(1)), std::nullopt, kFromAbove);
  EXPECT_NEAR(alone.cover, 0.25, 0.02);
  Ground ground;
  ground.colour = Vec3(0.04F);
  ground.height = -1;
  const MeanSeen over = mean_seen(scene, uniform_light(Vec3(1)), ground, kFromAbove);
  EXPECT_NEAR(over.cover, 1, 0.02);
  EXPECT_NEAR(over.light.g, 0.25 + 0.75 * 0.04, 0.03);
}

TEST(PathTracer, TheShadowOfGlassIsAsFaintAsTheGlass) {
  MeshScene scene = level_square(white());
  scene.meshes[0].frames[0].origin.y = 1;
  Ground ground;
  ground.colour = Vec3(0.5F);
  const Ray onto_ground{{0, 0.5F, 0}, {0, -1, 0}};
  const auto brightness = [&](float opacity) {
    scene.materials[0].opacity = opacity;
    return mean_seen(scene, uniform_light(Vec3(0)), ground, onto_ground, Lamplight({{.position = {0, 2, 0}}})).light.g;
  };
  const float open = brightness(0);
  EXPECT_GT(open, 0.05F);
  EXPECT_NEAR(brightness(0.4F) / open, 0.6, 0.1);
  EXPECT_LT(brightness(1) / open, 0.05F);
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
  const MeanSeen seen = mean_seen(level_square(leaf), uniform_light(Vec3(1)), std::nullopt, kFromAbove);
  EXPECT_LE(seen.light.g, 1.001F);
}

/// Returns the level square with u to the east, v to the north, and a texture.
MeshScene textured_square(Texture texture) {
  MeshScene scene = level_square(white());
  Mesh mesh = square(1);
  mesh.uvs = {{0, 1}, {0, 0}, {1, 0}, {1, 1}};
  scene.meshes[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  scene.materials[0].texture = std::make_shared<const Texture>(std::move(texture));
  return scene;
}

/// Returns a texture of one row of pixels, given as red, green, blue and alpha in turn.
Texture row_of(std::vector<std::uint8_t> rgba) {
  Texture texture;
  texture.colour = {static_cast<int>(rgba.size() / 4), 1, std::move(rgba)};
  return texture;
}

const Ray kOnWest{{-0.5F, 2, 0.3F}, {0, -1, 0}};
const Ray kOnEast{{0.5F, 2, 0.3F}, {0, -1, 0}};

TEST(PathTracer, ATextureGivesBackItsShareOfAUniformSky) {
  const MeshScene scene = textured_square(row_of({255, 128, 0, 255, 0, 255, 128, 255}));
  const Daylight light = uniform_light({1, 0.5F, 2});
  const Vec3 west = mean_seen(scene, light, std::nullopt, kOnWest).light;
  EXPECT_NEAR(west.r, 1, 1e-3);
  EXPECT_NEAR(west.g, 0.5 * 0.21586, 1e-3);
  EXPECT_NEAR(west.b, 0, 1e-3);
  const Vec3 east = mean_seen(scene, light, std::nullopt, kOnEast).light;
  EXPECT_NEAR(east.r, 0, 1e-3);
  EXPECT_NEAR(east.g, 0.5, 1e-3);
  EXPECT_NEAR(east.b, 2 * 0.21586, 1e-3);
}

TEST(PathTracer, TextureMaterialAndInstanceMultiply) {
  Texture texture = row_of({188, 188, 188, 255});
  texture.mean = Vec3(0.5F);
  MeshScene scene = textured_square(texture);
  scene.materials[0].colour = Vec3(0.5F, 0.5F, 0.25F);
  scene.meshes[0].tints = {Vec3(0.5F, 1, 1)};
  const Vec3 expected = linear_from_srgb(Vec3(188 / 255.0F)) * scene.materials[0].tint() * Vec3(0.5F, 1, 1);
  const Vec3 seen = mean_seen(scene, uniform_light(Vec3(1)), std::nullopt, kFromAbove).light;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], expected[c], 2e-3 * expected[c]);
}

TEST(PathTracer, ATextureFarAwayHasTheColourOfItsMean) {
  const MeshScene scene = textured_square(row_of({255, 255, 255, 255, 0, 0, 0, 255}));
  Ray ray = kOnWest;
  ray.spread = 2;  // 4 m wide at the square of 2 m
  EXPECT_NEAR(mean_seen(scene, uniform_light(Vec3(1)), std::nullopt, ray).light.g, 0.5, 1e-3);
}

/// Returns the brightness of a square whose normal map points 60° toward u, in the sun from `azimuth_deg` at 60°
/// altitude.
float brightness_with_tilted_normals(double azimuth_deg, bool has_tangents) {
  Texture texture = row_of({255, 255, 255, 255});
  texture.normals = {1, 1, {238, 128, 191, 255}};
  MeshScene scene = textured_square(texture);
  scene.materials[0].roughness = 1;
  if (has_tangents) {
    Mesh mesh = *scene.meshes[0].mesh;
    mesh.normals.assign(4, Vec3(0, 1, 0));
    mesh.tangents.assign(4, Vec4(1, 0, 0, 1));
    scene.meshes[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  }
  const Sky sky({radians(azimuth_deg), radians(60)});
  const Daylight sun_and_sky(sky, Vec3(0));
  const Daylight sky_alone([&](Vec3 direction) { return sky.radiance(direction); }, Vec3(0));
  return (mean_seen(scene, sun_and_sky, std::nullopt, kFromAbove).light.g -
          mean_seen(scene, sky_alone, std::nullopt, kFromAbove).light.g) *
         static_cast<float>(kPi) / sky.sun_irradiance().g;
}

TEST(PathTracer, ANormalMapLightsWithTheCosineOfItsNormal) {
  for (const bool has_tangents : {false, true}) {
    EXPECT_NEAR(brightness_with_tilted_normals(90, has_tangents), std::cos(radians(30)), 0.03);     // u points east
    EXPECT_NEAR(brightness_with_tilted_normals(270, has_tangents), 0, 0.03);                        // 90° away from it
    EXPECT_NEAR(brightness_with_tilted_normals(0, has_tangents), std::sin(radians(60)) / 2, 0.03);  // sideways
  }
}

TEST(PathTracer, ATexturedBladeShinesThroughInItsColour) {
  Texture texture = row_of({120, 160, 60, 255});
  MeshScene scene = textured_square(texture);
  scene.materials[0].two_sided = true;
  scene.materials[0].translucency = 0.5F;
  const Daylight light(Sky({0, radians(80)}), Vec3(0));
  const Vec3 through = mean_seen(scene, light, std::nullopt, kFromBelow).light;
  EXPECT_GT(through.g, 0.05F);
  EXPECT_GT(through.g, 2 * through.b);
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

TEST(Daylight, FallsAsBrightAsItIsSeenButPaler) {
  const Daylight light(Sky({radians(200), radians(35)}), Vec3(0.2F));
  const auto blueness = [](Vec3 colour) { return colour.b / luminance(colour); };
  for (const int azimuth_deg : {20, 140, 260}) {
    const Vec3 direction = unit_vector({radians(azimuth_deg), radians(60)});
    EXPECT_NEAR(luminance(light.falling(direction)), luminance(light.seen(direction)), 1e-4);
    EXPECT_LT(blueness(light.falling(direction)), blueness(light.seen(direction)));
    EXPECT_GT(blueness(light.falling(direction)), 1);
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
  const RayScene instances(scene, progress, {.copied_triangles = 0});
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

TEST(RayScene, RaysPassTheHolesOfAMask) {
  Texture texture = row_of({255, 255, 255, 255, 255, 255, 255, 0});
  texture.masked = true;
  MeshScene scene = textured_square(texture);
  scene.meshes[0].frames = {Frame(), Frame()};
  scene.meshes[0].frames[1].origin.y = -1;
  Progress progress;
  for (const std::uint64_t copied_triangles : {1000U, 0U}) {
    const RayScene rays(scene, progress, {.copied_triangles = copied_triangles});
    EXPECT_TRUE(rays.first_hit(kOnWest));
    EXPECT_TRUE(rays.is_blocked(kOnWest));
    EXPECT_FALSE(rays.first_hit(kOnEast));
    EXPECT_FALSE(rays.is_blocked(kOnEast));
  }
  auto closed = std::make_shared<Texture>(texture);
  closed->masked = false;
  scene.materials[0].texture = closed;
  EXPECT_TRUE(RayScene(scene, progress).is_blocked(kOnEast));
}

TEST(RayScene, TexturesLieAlongTheirUvsOnTurnedAndMirroredInstances) {
  MeshScene scene = textured_square(row_of({255, 255, 255, 255}));
  Frame mirrored;
  mirrored.axes[0].x = -2;
  scene.meshes[0].frames = {mirrored};
  Progress progress;
  const RayScene rays(scene, progress);
  const auto hit = rays.first_hit({{1, 2, 0.5F}, {0, -1, 0}});
  ASSERT_TRUE(hit);
  const TextureMapping place = rays.texture_mapping(*hit);
  EXPECT_NEAR(place.uv.x, 0.25, 1e-5);
  EXPECT_NEAR(place.uv.y, 0.25, 1e-5);
  EXPECT_NEAR(place.uvs_per_metre, std::sqrt(1.0 / 8), 1e-5);
  EXPECT_LT(glm::distance(place.along_u, Vec3(-1, 0, 0)), 1e-5);
  EXPECT_LT(glm::distance(place.along_v, Vec3(0, 0, -1)), 1e-5);
}

TEST(RayScene, StopsBuildingWhenCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(RayScene(level_square(white()), progress), Cancelled);
}

TEST(PathTracer, HazeTakesItsShareOfWhatIsSeen) {
  // A white plane under a sky of 1 is as bright as the sky, so only a darker plane shows the haze. The remaining
  // difference to the sky is exp(-distance / haze distance).
  Material grey;
  grey.colour = srgb_from_linear(Vec3(0.5F));
  const MeshScene scene = level_square(grey);
  Progress progress;
  const RayScene rays(scene, progress);
  const Daylight light = uniform_light(Vec3(1));
  const PathTracer clear(scene, rays, light, std::nullopt);
  const PathTracer hazy(scene, rays, light, std::nullopt, Lamplight(), Air{.haze = 4.0F, .clouds = {}});
  double plain = 0, hidden = 0;
  for (std::uint32_t s = 0; s < kSamples; ++s) {
    SampleStream first(7, s, kSamples), second(7, s, kSamples);
    plain += clear.trace(kFromAbove, first).light().g;
    hidden += hazy.trace(kFromAbove, second).light().g;
  }
  EXPECT_NEAR((1 - hidden / kSamples) / (1 - plain / kSamples), std::exp(-2.0 / 4), 0.02);
}

}  // namespace meristem::path_tracer_test
