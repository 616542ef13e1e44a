// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/photographer.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/colour.h"
#include "meristem/base/random.h"
#include "meristem/output/picture/film.h"

namespace meristem::photographer_test {

constexpr int kSize = 40;

/// Returns two hundred leaves before the sky, pale above and dark below.
MeshScene leaves() {
  Mesh leaf;
  leaf.positions = {{-0.05F, 0, -0.08F}, {-0.05F, 0, 0.08F}, {0.05F, 0, 0.08F}, {0.05F, 0, -0.08F}};
  leaf.triangles = {{0, 1, 2}, {0, 2, 3}};
  MeshScene scene;
  scene.materials.resize(1);
  scene.materials[0].colour = {0.8F, 0.9F, 0.7F};
  scene.materials[0].two_sided = true;
  scene.materials[0].translucency = 0.2F;
  scene.meshes = {{"leaf", std::make_shared<const Mesh>(leaf), 0, {}}};
  const RandomKey key(1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 place = 0.5F * key.direction(i) * Vec3(1, 0.6F, 1);
    scene.meshes[0].frames.push_back(frame_along(place, key.child(1).direction(i), kUp));
  }
  return scene;
}

/// Returns the pixels of a picture of one tile.
std::vector<PixelLight> pixels(const Photographer& photographer, int size, Progress& progress) {
  Film film(size, size, photographer.pixel_angle());
  film.keep(0, 0, photographer.expose(film.tile(0, 0), progress));
  return film.pixels(0, 0);
}

class PhotographedLeaves : public testing::Test {
 protected:
  std::vector<PixelLight> exposed(int samples, bool is_even, bool shows_sky = true) {
    return pixels(Photographer(tracer_, camera_, {kSize, kSize, samples, 2.0F, shows_sky, is_even}), kSize, progress_);
  }

  Progress progress_;
  MeshScene meshes_ = leaves();
  RayScene rays_{meshes_, progress_};
  Sky sky_{{radians(120), radians(50)}};
  PathTracer tracer_{meshes_, rays_, Daylight(sky_, Vec3(0.1F)), std::nullopt};
  Camera camera_{{0, 0, 3}, {0, 0, 0}, radians(32), 1};
};

double mean_brightness(const std::vector<PixelLight>& pixels) {
  double sum = 0;
  for (const PixelLight& pixel : pixels) sum += luminance(pixel.light);
  return sum / static_cast<double>(pixels.size());
}

double mean_samples(const std::vector<PixelLight>& pixels) {
  double sum = 0;
  for (const PixelLight& pixel : pixels) sum += pixel.samples;
  return sum / static_cast<double>(pixels.size());
}

double error(const std::vector<PixelLight>& pixels, const std::vector<PixelLight>& truth) {
  double sum = 0;
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const double difference = luminance(pixels[k].light) - luminance(truth[k].light);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(pixels.size()));
}

TEST_F(PhotographedLeaves, SkyTakesFewSamplesAndLeavesTakeMany) {
  const std::vector<PixelLight> pixels = exposed(64, false);
  EXPECT_LE(pixels[0].samples, 8);
  int max = 0;
  for (const PixelLight& pixel : pixels) max = std::max(max, pixel.samples);
  EXPECT_EQ(max, 64);
}

TEST_F(PhotographedLeaves, StoppingEarlyDoesNotDarken) {
  // The mean over all pixels varies by some thousandths by chance.
  const double expected = mean_brightness(exposed(512, true));
  for (const int samples : {16, 32, 64, 100}) {
    EXPECT_NEAR(mean_brightness(exposed(samples, false)), expected, 0.01 * expected) << samples << " samples";
  }
}

TEST_F(PhotographedLeaves, MoreSamplesHaveLessNoise) {
  const std::vector<PixelLight> truth = exposed(4096, true);
  double before = 1;
  for (const int samples : {4, 64, 512, 2048}) {
    const double now = error(exposed(samples, false), truth);
    EXPECT_LT(now, 0.75 * before) << samples << " samples";
    before = now;
  }
}

TEST_F(PhotographedLeaves, SavesSamplesWhereTheNoiseIsBorne) {
  const std::vector<PixelLight> saving = exposed(64, false);
  EXPECT_LT(mean_samples(saving), 48);
  EXPECT_LT(error(saving, exposed(512, true)), 0.015);
}

TEST_F(PhotographedLeaves, EvenSettingsTakeAllSamplesEverywhere) {
  for (const PixelLight& pixel : exposed(12, true)) EXPECT_EQ(pixel.samples, 12);
}

TEST_F(PhotographedLeaves, WithoutSkyCoverIsTheShareThatIsHidden) {
  const std::vector<PixelLight> pixels = exposed(64, false, false);
  EXPECT_EQ(pixels[0].cover, 0);
  EXPECT_EQ(pixels[0].light, Vec3(0));
  double cover = 0;
  double expected = 0;
  for (const PixelLight& pixel : pixels) cover += pixel.cover;
  for (const PixelLight& pixel : exposed(512, true, false)) expected += pixel.cover;
  EXPECT_NEAR(cover, expected, 0.005 * expected);
}

TEST_F(PhotographedLeaves, AnyNumberOfSamplesIsExposed) {
  for (const int samples : {1, 2, 3, 5, 9, 33}) {
    for (const PixelLight& pixel : exposed(samples, false)) {
      ASSERT_GE(pixel.samples, std::min(samples, 4));
      ASSERT_LE(pixel.samples, samples);
      ASSERT_TRUE(std::isfinite(luminance(pixel.light)));
      ASSERT_EQ(pixel.cover, 1);
    }
  }
}

TEST_F(PhotographedLeaves, ATileIsThePartOfThePictureWhereItLies) {
  const Photographer photographer(tracer_, camera_, {kSize, kSize, 16, 2.0F, true, true});
  const Exposure whole = photographer.expose({0, 0, kSize, kSize}, progress_);
  const Tile tile{17, 9, 30, 20};
  const Exposure part = photographer.expose(tile, progress_);
  for (int y = tile.top; y < tile.bottom; ++y) {
    for (int x = tile.left; x < tile.right; ++x) {
      const int here = (y - tile.top) * 13 + x - tile.left;
      const int there = y * kSize + x;
      EXPECT_EQ(part.pixels[here].direct, whole.pixels[there].direct);
      EXPECT_EQ(part.pixels[here].albedo, whole.pixels[there].albedo);
      EXPECT_EQ(part.indirect[here].sum(), whole.indirect[there].sum());
    }
  }
}

TEST(Photographer, AWhitePlaneUnderAUniformSkyIsAsBrightAsTheSkyEverywhere) {
  Mesh plane;
  plane.positions = {{-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, {9, 0, -9}};
  plane.triangles = {{0, 1, 2}, {0, 2, 3}};
  MeshScene meshes;
  meshes.materials.resize(1);
  meshes.materials[0].colour = Vec3(1);
  meshes.meshes = {{"plane", std::make_shared<const Mesh>(plane), 0, {Frame()}}};
  Progress progress;
  const RayScene rays(meshes, progress);
  const PathTracer tracer(meshes, rays, Daylight([](Vec3) { return Vec3(1); }, Vec3(1)), std::nullopt);
  const Camera camera({0, 2, 2}, {0, 0, 0}, radians(60), 1);
  const Photographer photographer(tracer, camera, {.width = 16, .height = 16, .samples = 64});
  for (const PixelLight& pixel : pixels(photographer, 16, progress)) {
    EXPECT_LE(pixel.samples, 8);
    EXPECT_NEAR(pixel.light.g, 1, 1e-3);
  }
}

TEST(Photographer, AnEdgeIsSmoothedByATentOfTwoPixels) {
  // A wall to the left of the picture's middle, which lies between pixels 7 and 8.
  Mesh wall;
  wall.positions = {{-90, -90, 0}, {0, -90, 0}, {0, 90, 0}, {-90, 90, 0}};
  wall.triangles = {{0, 1, 2}, {0, 2, 3}};
  MeshScene meshes;
  meshes.materials.resize(1);
  meshes.meshes = {{"wall", std::make_shared<const Mesh>(wall), 0, {Frame()}}};
  Progress progress;
  const RayScene rays(meshes, progress);
  const PathTracer tracer(meshes, rays, Daylight([](Vec3) { return Vec3(1); }, Vec3(1)), std::nullopt);
  const Camera camera({0, 0, 100}, {0, 0, 0}, radians(20), 1);
  const Photographer photographer(tracer, camera, {.width = 16, .height = 16, .samples = 64, .shows_sky = false});
  const std::vector<PixelLight> seen = pixels(photographer, 16, progress);
  const auto cover = [&](int x) { return seen[8 * 16 + x].cover; };
  EXPECT_EQ(cover(6), 1);
  EXPECT_NEAR(cover(7), 0.875, 0.02);
  EXPECT_NEAR(cover(8), 0.125, 0.02);
  EXPECT_EQ(cover(9), 0);
}

}  // namespace meristem::photographer_test
