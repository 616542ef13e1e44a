// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/cloud_motion.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/math.h"

namespace meristem::cloud_motion_test {

constexpr float kFar = std::numeric_limits<float>::infinity();

// A cloud of four points above a root, in the light of a scene.
class Motion {
 public:
  Motion(const Scene& scene, const LightResponse& response)
      : motion_(scene, Vec3(0), {{.response = response, .base = 0, .top = 4}}), points_(four_points()) {
    motion_.add_node(Vec3(0), response.sunlit_weight);
    points_.add_nodes(0, std::vector<MovingPoints::NewNode>{{Vec3(0), kFar}}, progress_);
  }
  void move() { motion_.move(points_, progress_); }
  const MovingPoint& operator[](std::size_t k) const { return points_.points()[k]; }

 private:
  static MovingPoints four_points() {
    std::vector<MovingPoint> points(4);
    for (std::size_t k = 0; k < 4; ++k)
      points[k].position = Vec3(0.5F * static_cast<float>(k), 1.0F + static_cast<float>(k), 0);
    return MovingPoints(points);
  }

  Progress progress_;
  CloudMotion motion_;
  MovingPoints points_;
};

Scene lit_from(Vec3 toward) {
  Scene scene;
  scene.light.sun = {{toward, 1}};
  return scene;
}

void expect_near(Vec3 a, Vec3 b) { EXPECT_LT(glm::distance(a, b), 1e-5F) << a.x << ' ' << a.y << ' ' << a.z; }

TEST(CloudMotion, ShiftsAllPointsAlikeTowardTheLight) {
  const Scene scene = lit_from(Vec3(0, 0.6F, 0.8F));
  Motion motion(scene, {.shift = 0.1});
  motion.move();
  for (std::size_t k = 0; k < 4; ++k) {
    expect_near(motion[k].position, Vec3(0.5F * static_cast<float>(k), 1.06F + static_cast<float>(k), 0.08F));
  }
}

TEST(CloudMotion, ShiftsByTheSameLengthHoweverWeakTheLight) {
  const Scene scene = lit_from(kUp);
  Motion motion(scene, {.shift = 0.1, .sunlit_weight = 0.01});
  motion.move();
  expect_near(motion[0].position, Vec3(0, 1.1F, 0));
}

TEST(CloudMotion, DriftsByTheStrengthOfWhatTheNodeFeels) {
  const Scene scene = lit_from(kUp);
  Motion motion(scene, {.drift = 0.1, .sunlit_weight = 0.25});
  motion.move();
  expect_near(motion[0].position, Vec3(0, 1.025F, 0));
}

TEST(CloudMotion, HoldsTheTopAtItsHeight) {
  const Scene scene = lit_from(Vec3(0, 0.6F, 0.8F));
  Motion motion(scene, {.shift = 0.1, .hold_height = true});
  for (int k = 0; k < 20; ++k) motion.move();
  EXPECT_NEAR(motion[3].position.y, 4, 1e-4);
  EXPECT_NEAR(motion[3].position.z, 20 * 0.08, 1e-4);
  EXPECT_GT(motion[0].position.y, 1);  // lower points rise a little toward the top
  EXPECT_LT(motion[0].position.y, 2.3);
}

TEST(CloudMotion, LaysPointsToRestInsideObstaclesAndWakesThemBeyond) {
  Scene scene = lit_from(Vec3(0, 0, 1));
  Obstacle wall;
  wall.mesh = box_mesh({-1, 0.5, 0.15}, {0.2, 1.5, 0.25});
  scene.obstacles = Obstacles({wall});
  Motion motion(scene, {.shift = 0.1, .sunlit_weight = 1});
  // The node at the origin is not shaded: the wall begins above it.
  motion.move();
  EXPECT_FALSE(motion[0].is_inert);
  motion.move();
  EXPECT_TRUE(motion[0].is_inert);
  EXPECT_FALSE(motion[1].is_inert);
  motion.move();
  EXPECT_FALSE(motion[0].is_inert);
}

TEST(CloudMotion, StandsStillInTheDark) {
  Scene scene;
  scene.light.sun.clear();
  Motion motion(scene, {.shift = 0.1, .drift = 0.1});
  motion.move();
  expect_near(motion[2].position, Vec3(1, 3, 0));
}

}  // namespace meristem::cloud_motion_test
