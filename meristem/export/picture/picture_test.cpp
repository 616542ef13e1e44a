// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/picture/picture.h"

#include <gtest/gtest.h>

#include "tests/support/sample_scenes.h"

namespace meristem::picture_test {

/// Returns a tree whose crown reaches well beyond its only visible part, a small triangle.
GrownDocument crown_about_a_triangle() {
  GrownDocument grown;
  grown.meshes = scene_of(triangle(), {Frame()});
  Skeleton& tree = grown.plant.stems.emplace_back().skeleton;
  tree.add_node(kNoNode, {0, -1, 0}, 0);
  tree.add_node(0, {0, -0.5F, 0}, 1);
  for (const Vec3 tip : {Vec3(-0.3F, 2, 0), Vec3(3, 2, 0), Vec3(1, 2, 2), Vec3(1, 0.2F, -1)}) {
    const NodeIndex node = tree.add_node(1, tip, 2);
    tree.axis[node] = node - 1;
    tree.order[node] = node == 2 ? 0 : 1;
  }
  return grown;
}

PictureOptions small_picture() {
  return {.still = {.width = 40, .height = 30, .samples = 4, .transparent = true}, .view = CameraView()};
}

TEST(Picture, WithoutHullsIsTheStillOfTheMeshes) {
  const GrownDocument grown = crown_about_a_triangle();
  const PictureOptions options = small_picture();
  Progress progress;
  EXPECT_EQ(take_picture(grown, {}, Scene(), options, progress).rgba,
            render_still(grown.meshes, Scene(), options.view, options.still, progress).rgba);
}

TEST(Picture, HullsAreDrawnAboutThePlantsAndDoNotMoveThem) {
  const GrownDocument grown = crown_about_a_triangle();
  PictureOptions options = small_picture();
  Progress progress;
  const Image plain = take_picture(grown, {}, Scene(), options, progress);
  options.crown_hulls = true;
  const Image with_hulls = take_picture(grown, {}, Scene(), options, progress);
  ASSERT_EQ(with_hulls.rgba.size(), plain.rgba.size());
  std::size_t covered = 0;
  std::size_t added = 0;
  for (std::size_t alpha = 3; alpha < plain.rgba.size(); alpha += 4) {
    EXPECT_GE(with_hulls.rgba[alpha], plain.rgba[alpha]) << "pixel " << alpha / 4;
    covered += plain.rgba[alpha] > 0 ? 1 : 0;
    added += with_hulls.rgba[alpha] > plain.rgba[alpha] ? 1 : 0;
  }
  EXPECT_GT(covered, 100U);
  EXPECT_GT(added, 10U);
}

TEST(Picture, OfNothingHasNoHulls) {
  PictureOptions options = small_picture();
  Progress progress;
  const Image plain = take_picture({}, {}, Scene(), options, progress);
  options.crown_hulls = true;
  EXPECT_EQ(take_picture({}, {}, Scene(), options, progress).rgba, plain.rgba);
}

}  // namespace meristem::picture_test
