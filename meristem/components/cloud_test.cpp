// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/cloud.h"

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"

namespace meristem::cloud_test {

const Value kBall = Value::Object{{"sphere", Value::Object{{"centre", Value::List{0, 2, 0}}, {"radius", 0.5}}}};

GraphBuilder cloud(Value::Object parameters) {
  GraphBuilder builder(builtin_components());
  return builder.component("view", "camera").component("dots", "cloud", parameters).link("view", "dots");
}

TEST(Cloud, ShowsEachPointAsADotOfTheSameSphere) {
  const Plant plant = cloud({{"crown", kBall}, {"points", 300}, {"size", 0.02}}).grow();
  EXPECT_EQ(organs_of(plant, "dots").size(), 300U);
  ASSERT_EQ(prototypes_of(plant, "dots").size(), 1U);
  EXPECT_TRUE(plant.stems.empty());
  for (const Organ& organ : plant.organs) {
    EXPECT_LE(glm::distance(organ.frame.origin, Vec3(0, 2, 0)), 0.5F);
    EXPECT_FLOAT_EQ(glm::length(organ.frame.axes[1]), 0.02F);
  }
}

TEST(Cloud, PointsHaveTheSharesOfTheirCrownsParts) {
  const Value upper = Value::Object{{"share", 1}, {"above", 0.5}};
  const Plant plant =
      cloud({{"crown", kBall}, {"points", Value::Object{{"count", 50}, {"shares", Value::List{upper}}}}}).grow();
  ASSERT_EQ(plant.organs.size(), 50U);
  for (const Organ& organ : plant.organs) EXPECT_GE(organ.frame.origin.y, 2);
}

TEST(Cloud, StandsInItsFrame) {
  const Value there = Value::Object{{"translate", Value::List{3, 0, 0}}, {"scale", Value::List{2, 2, 2}}};
  const Plant plant = cloud({{"crown", kBall}, {"points", 40}, {"frame", there}}).grow();
  ASSERT_EQ(plant.organs.size(), 40U);
  for (const Organ& organ : plant.organs) EXPECT_LE(glm::distance(organ.frame.origin, Vec3(3, 4, 0)), 1.0001F);
}

TEST(Cloud, IsTheSameOnAnyNumberOfThreads) {
  const auto grown = [](int threads) {
    const ThreadLimit limit(threads);
    return hash_of(cloud({{"crown", kBall}, {"points", 2000}}).grow());
  };
  const std::string expected = grown(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(grown(threads), expected) << threads;
}

TEST(Cloud, NeedsACrownAndABearableNumberOfPoints) {
  EXPECT_EQ(errors_of([] { cloud({}); }).at(0).message, "a cloud has no 'crown'");
  EXPECT_EQ(errors_of([] { cloud({{"crown", kBall}, {"points", 1e12}}); }).at(0).path, "components.dots.points");
}

// A block over the upper half of the ball.
Scene half_blocked_scene() {
  Scene scene;
  Obstacle block;
  block.mesh = box_mesh({-2, 2, -2}, {2, 4, 2});
  scene.obstacles = Obstacles({block});
  return scene;
}

TEST(Cloud, LeavesOutWhatObstaclesTake) {
  const Plant plant = cloud({{"crown", kBall}, {"points", 400}}).grow(0, half_blocked_scene());
  EXPECT_NEAR(static_cast<double>(plant.organs.size()), 200, 40);
  for (const Organ& organ : plant.organs) EXPECT_LT(organ.frame.origin.y, 2);
}

TEST(Cloud, ShowsWhatIsTakenInItsOwnColour) {
  const Plant plant = cloud({{"crown", kBall}, {"points", 400}, {"colour", "#808080"}, {"removed_colour", "#ff8080"}})
                          .grow(0, half_blocked_scene());
  EXPECT_EQ(plant.organs.size(), 400U);
  for (const Organ& organ : plant.organs) {
    const bool is_removed = organ.frame.origin.y >= 2;
    EXPECT_EQ(organ.tint.x > 1.5F, is_removed);
    EXPECT_NEAR(organ.tint.y, 1, 1e-5);
  }
}

TEST(Cloud, LeavesOutTheDarkestShare) {
  const auto lowest = [](double share) {
    const Plant plant =
        cloud({{"crown", kBall}, {"points", 400}, {"limit", Value::Object{{"share", share}, {"k", 1}}}}).grow();
    EXPECT_NEAR(static_cast<double>(plant.organs.size()), 400 * (1 - share), 1);
    float mean = 0;
    for (const Organ& organ : plant.organs) mean += organ.frame.origin.y / static_cast<float>(plant.organs.size());
    return mean;
  };
  EXPECT_GT(lowest(0.5), lowest(0) + 0.1F);
}

}  // namespace meristem::cloud_test
