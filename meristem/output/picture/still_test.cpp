// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/still.h"

#include <algorithm>
#include <atomic>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"

namespace meristem::still_test {

/// Returns a block of 1 m that stands at the origin, and a few hundred leaves above it.
MeshScene block_with_leaves() {
  Mesh block;
  for (int corner = 0; corner < 8; ++corner) {
    block.positions.emplace_back((corner & 1) - 0.5F, corner & 2 ? 1 : 0, (corner & 4 ? 0.5F : -0.5F));
  }
  block.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 4, 6}, {0, 6, 2},
                     {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3}};
  Mesh leaf;
  leaf.positions = {{0, 0, 0}, {0.1F, 0.1F, 0}, {-0.1F, 0.1F, 0}, {0, 0.2F, 0}};
  leaf.triangles = {{0, 1, 2}, {2, 1, 3}};
  MeshScene scene;
  scene.materials.resize(2);
  scene.materials[1].colour = {0.3F, 0.5F, 0.2F};
  scene.materials[1].two_sided = true;
  scene.materials[1].translucency = 0.4F;
  scene.meshes = {{"block", std::make_shared<const Mesh>(block), 0, {Frame()}},
                  {"leaf", std::make_shared<const Mesh>(leaf), 1, {}}};
  const RandomKey key(1);
  for (int i = 0; i < 300; ++i) {
    const Vec3 position = Vec3(0, 1.2F, 0) + 0.5F * key.direction(i);
    scene.meshes[1].frames.push_back(frame_along(position, key.child(1).direction(i), kUp));
  }
  return scene;
}

StillOptions small(int size, int samples) {
  StillOptions options;
  options.width = options.height = size;
  options.samples = samples;
  return options;
}

const std::uint8_t* pixel(const Image& image, int x, int y) {
  return image.rgba.data() + std::size_t{4} * (y * image.width + x);
}

int brightness(const Image& image, int x, int y) {
  const std::uint8_t* rgba = pixel(image, x, y);
  return rgba[0] + rgba[1] + rgba[2];
}

TEST(Still, IsTheSamePictureOnAnyNumberOfThreads) {
  const MeshScene meshes = block_with_leaves();
  Scene scene;
  scene.sun = {1, 0.6};
  const auto render = [&](int threads) {
    const ThreadLimit limit(threads);
    Progress progress;
    return render_still(meshes, scene, CameraView(), small(50, 4), progress).rgba;
  };
  const std::vector<std::uint8_t> expected = render(1);
  for (const int threads : {2, 3, 8}) EXPECT_TRUE(render(threads) == expected) << threads << " threads";
}

TEST(Still, LampsLightTheNightTheSameOnAnyNumberOfThreads) {
  const MeshScene meshes = block_with_leaves();
  Scene scene;
  scene.sun = {0, radians(-40)};
  scene.light.lamps = {{{1, 2, 1}, 0.3}, {{-1, 2, 1}, 0.1}, {{0, 3, 0}, 0.1}};
  const auto render = [&](int threads) {
    const ThreadLimit limit(threads);
    Progress progress;
    return render_still(meshes, scene, CameraView(), small(50, 4), progress);
  };
  const Image expected = render(1);
  for (const int threads : {2, 3, 8}) EXPECT_TRUE(render(threads).rgba == expected.rgba) << threads << " threads";
  // At night, surfaces near a lamp are brighter than the sky.
  int brightest = 0;
  for (int x = 0; x < 50; ++x) brightest = std::max(brightest, brightness(expected, x, 25));
  EXPECT_GT(brightest, 300);
  EXPECT_LT(brightness(expected, 0, 0), 200);
}

/// Returns the block with leaves that a texture cuts out and tilts, each in its own colour.
MeshScene block_with_textured_leaves() {
  MeshScene scene = block_with_leaves();
  Mesh leaf = *scene.meshes[1].mesh;
  leaf.uvs = {{0.5F, 0}, {1, 0.5F}, {0, 0.5F}, {0.5F, 1}};
  scene.meshes[1].mesh = std::make_shared<const Mesh>(std::move(leaf));
  auto texture = std::make_shared<Texture>();
  texture->masked = true;
  texture->colour = {2, 2, {40, 90, 20, 255, 90, 120, 30, 0, 60, 110, 20, 0, 120, 140, 60, 200}};
  texture->normals = {2, 1, {150, 128, 250, 255, 110, 140, 250, 255}};
  texture->mean = Vec3(0.05F, 0.12F, 0.02F);
  scene.materials[1].texture = texture;
  for (std::size_t i = 0; i < scene.meshes[1].frames.size(); ++i) {
    scene.meshes[1].tints.push_back(Vec3(0.8F) + 0.4F * Vec3(RandomKey(3).uniform(i)));
  }
  return scene;
}

TEST(Still, TexturedLeavesAreTheSameOnAnyNumberOfThreads) {
  const MeshScene meshes = block_with_textured_leaves();
  const auto render = [&](int threads) {
    const ThreadLimit limit(threads);
    Progress progress;
    return render_still(meshes, Scene(), CameraView(), small(50, 4), progress).rgba;
  };
  const std::vector<std::uint8_t> expected = render(1);
  for (const int threads : {2, 3, 8}) EXPECT_TRUE(render(threads) == expected) << threads << " threads";
}

TEST(Still, HolesLetTheBackgroundThrough) {
  StillOptions options = small(48, 16);
  options.transparent = true;
  Progress progress;
  const auto cover = [&](const MeshScene& meshes) {
    CameraView view;
    view.position = Vec3(0, 1.2F, 4);
    view.target = Vec3(0, 1.2F, 0);
    double sum = 0;
    const Image image = render_still(meshes, Scene(), view, options, progress);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) sum += image.rgba[i];
    return sum;
  };
  MeshScene whole = block_with_textured_leaves();
  whole.materials[1].texture = nullptr;
  EXPECT_LT(cover(block_with_textured_leaves()), 0.95 * cover(whole));
}

TEST(Still, TransparentPicturesHoldThePlantAlone) {
  StillOptions options = small(48, 4);
  options.transparent = true;
  Progress progress;
  const Image image = render_still(block_with_leaves(), Scene(), CameraView(), options, progress);
  ASSERT_EQ(image.rgba.size(), 4U * 48 * 48);
  EXPECT_EQ(pixel(image, 24, 32)[3], 255);
  for (const int corner : {0, 47}) {
    EXPECT_EQ(pixel(image, corner, 0)[3], 0);
    EXPECT_EQ(pixel(image, corner, 47)[3], 0);
  }
}

TEST(Still, AFlatBackgroundHasExactlyItsColour) {
  CameraView view;
  view.background = Vec3(51, 102, 204) / 255.0F;
  StillOptions options = small(32, 4);
  options.ground = false;
  Progress progress;
  const Image image = render_still(block_with_leaves(), Scene(), view, options, progress);
  const std::uint8_t* corner = pixel(image, 0, 0);
  EXPECT_EQ(corner[0], 51);
  EXPECT_EQ(corner[1], 102);
  EXPECT_EQ(corner[2], 204);
  EXPECT_EQ(corner[3], 255);
}

TEST(Still, TheShadowFallsAwayFromTheSun) {
  MeshScene meshes = block_with_leaves();
  meshes.meshes.pop_back();
  Scene scene;
  scene.sun = {radians(90), radians(45)};  // the sun stands in the east, on the right of a view to the north
  CameraView view;
  view.position = Vec3(0, 12, 0.01F);
  view.target = Vec3(0);
  view.field_of_view = 0.6;
  Progress progress;
  const Image image = render_still(meshes, scene, view, small(64, 16), progress);
  // From 12 m, 64 pixels span 7.4 m: the shadow reaches from the block (x > -0.5 m) to x = -1.5 m.
  EXPECT_LT(brightness(image, 23, 32), 2 * brightness(image, 41, 32) / 3);
  EXPECT_GT(brightness(image, 15, 32), 3 * brightness(image, 41, 32) / 4);
}

TEST(Still, RendersAnEmptyScene) {
  Progress progress;
  EXPECT_EQ(render_still(MeshScene(), Scene(), CameraView(), small(8, 1), progress).rgba.size(), 256U);
}

TEST(Still, CountsPixelsAndStopsWhenCancelled) {
  double last = 0;
  Progress counted([&](std::string_view, double fraction) { last = fraction; });
  render_still(block_with_leaves(), Scene(), CameraView(), small(40, 1), counted);
  EXPECT_EQ(last, 1);

  Progress* self = nullptr;
  Progress cancelled([&](std::string_view, double fraction) {
    if (fraction > 0.2) self->cancel();
  });
  self = &cancelled;
  EXPECT_THROW(render_still(block_with_leaves(), Scene(), CameraView(), small(100, 4), cancelled), Cancelled);
}

TEST(Still, RefusesSizesAndSamplesOutOfRange) {
  Progress progress;
  for (const int wrong : {0, -5, 16385}) {
    StillOptions options = small(8, 1);
    options.width = wrong;
    EXPECT_THROW(render_still(MeshScene(), Scene(), CameraView(), options, progress), InputError);
    options = small(8, 1);
    options.height = wrong;
    EXPECT_THROW(render_still(MeshScene(), Scene(), CameraView(), options, progress), InputError);
  }
  for (const int wrong : {0, 65537}) {
    EXPECT_THROW(render_still(MeshScene(), Scene(), CameraView(), small(8, wrong), progress), InputError);
  }
}

}  // namespace meristem::still_test
