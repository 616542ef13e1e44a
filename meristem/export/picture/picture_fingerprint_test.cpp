// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/picture/picture_fingerprint.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/sample_scenes.h"

namespace meristem::picture_fingerprint_test {

struct Subject {
  GrownDocument grown;
  Scene scene;
  PictureOptions options;

  Subject() { grown.meshes = scene_of(triangle(), {Frame()}); }
  std::string fingerprint() const { return picture_fingerprint(grown, {}, scene, options); }
};

TEST(PictureFingerprint, IsThatOfAnEqualPicture) { EXPECT_EQ(Subject().fingerprint(), Subject().fingerprint()); }

TEST(PictureFingerprint, DiffersWhereAnythingThatIsDrawnDiffers) {
  const std::vector<std::function<void(Subject&)>> changes{
      [](Subject& s) { s.grown.meshes.materials[0].colour.x += 0.01F; },
      [](Subject& s) { s.grown.meshes.materials[0].texture = std::make_shared<Texture>(); },
      [](Subject& s) { s.grown.meshes.meshes[0].frames[0].origin.y += 0.001F; },
      [](Subject& s) { s.grown.meshes.meshes[0].frames.emplace_back(); },
      [](Subject& s) { s.grown.meshes.meshes[0].tints = {Vec3(0.5F)}; },
      [](Subject& s) { s.scene.sun.azimuth += 0.1; },
      [](Subject& s) { s.scene.ground_colour.x = 0; },
      [](Subject& s) { s.scene.light.lamps.emplace_back(); },
      [](Subject& s) { s.options.view.position = Vec3(1); },
      [](Subject& s) { s.options.view.azimuth += 0.1; },
      [](Subject& s) { s.options.still.samples += 1; },
      [](Subject& s) { s.options.still.transparent = true; },
      [](Subject& s) { s.options.crown_hulls = true; },
  };
  const std::string plain = Subject().fingerprint();
  for (std::size_t k = 0; k < changes.size(); ++k) {
    Subject changed;
    changes[k](changed);
    EXPECT_NE(changed.fingerprint(), plain) << "change " << k;
  }
}

TEST(PictureFingerprint, IsBlindToAnglesThatAPositionReplaces) {
  Subject placed;
  placed.options.view.position = Vec3(1, 2, 3);
  Subject turned = placed;
  turned.options.view.azimuth += 1;
  turned.options.view.altitude += 0.2;
  EXPECT_EQ(placed.fingerprint(), turned.fingerprint());
}

TEST(PictureFingerprint, FramesHaveNoGapsThatItCouldRead) { EXPECT_EQ(sizeof(Frame), 12 * sizeof(float)); }

}  // namespace meristem::picture_fingerprint_test
