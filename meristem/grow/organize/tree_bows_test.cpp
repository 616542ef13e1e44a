// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/tree_bows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/frame.h"
#include "meristem/base/parallel.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/organized_trees.h"

namespace meristem::tree_bows_test {

/// A straight stem of `count` metamers of one metre in the direction `way`.
Metamers straight(int count, Vec3 way) {
  Metamers metamers(way, any_perpendicular(way), RandomKey(1));
  for (MetamerIndex k = 0; k < static_cast<MetamerIndex>(count); ++k) {
    metamers.tip[metamers.grow(k, false, 1)] = metamers.tip[k] + way;
  }
  return metamers;
}

double inclination(const Metamers& metamers, MetamerIndex metamer) {
  return std::asin(static_cast<double>(metamers.heading(metamer).y));
}

TEST(TreeBows, BendToTheirInclinationInTheirTime) {
  Metamers metamers = straight(8, glm::normalize(Vec3(1, 1, 0)));
  TreeBows bows;
  bows.add({.first = 3, .last = 5, .tip = 8, .inclination = -0.3, .iterations = 4});
  const std::vector<Vec3> before = metamers.tip;
  for (int k = 0; k < 4; ++k) {
    EXPECT_FALSE(bows.empty());
    const double was = inclination(metamers, 5);
    metamers.tip = bows.bend(metamers).tip;
    EXPECT_NEAR(was - inclination(metamers, 5), (kPi / 4 + 0.3) / 4, 1e-4) << "in equal parts";
  }
  EXPECT_TRUE(bows.empty());
  EXPECT_NEAR(inclination(metamers, 5), -0.3, 1e-5);
  EXPECT_NEAR(inclination(metamers, 8), -0.3, 1e-5) << "what lies beyond turns along";
  EXPECT_NEAR(inclination(metamers, 4), (kPi / 4 - 2 * 0.3) / 3, 1e-2) << "an even arc";
  for (MetamerIndex metamer = 1; metamer <= 8; ++metamer) {
    EXPECT_NEAR(metamers.length(metamer), 1, 1e-5);
  }
  EXPECT_EQ(metamers.tip[2], before[2]);
}

TEST(TreeBows, NothingComesBelowTheGround) {
  Metamers metamers = straight(6, Vec3(0, 1, 0));
  TreeBows bows;
  bows.add({.first = 1, .last = 2, .tip = 6, .inclination = -kPi / 2, .iterations = 1});
  const TreePose pose = bows.bend(metamers);
  for (const Vec3 tip : pose.tip) EXPECT_GE(tip.y, 0);
}

TEST(TreeBows, EndWithWhatTheyBend) {
  Metamers metamers = straight(6, Vec3(0, 1, 0));
  TreeBows bows;
  bows.add({.first = 2, .last = 4, .tip = 6, .iterations = 3});
  std::vector<std::uint8_t> gone(metamers.count(), 0);
  gone[5] = 1;
  metamers.remove(gone, Bud::damaged());
  bows.remove(gone);
  EXPECT_FALSE(bows.empty());
  gone.assign(metamers.count(), 0);
  gone[4] = 1;
  metamers.remove(gone, Bud::damaged());
  bows.remove(gone);
  EXPECT_TRUE(bows.empty());
}

ShootChoice branches() {
  return {ShootChoice::Kind::condition, "rank == 1", Expression::compile("rank == 1", {shoot_variables(), {}})};
}

OrganizeParameters bent(int iterations) {
  OrganizeParameters parameters = full(iterations);
  TreeOperation& bend = parameters.operations.emplace_back();
  bend.when = OperationSchedule::at(8);
  bend.shoots = branches();
  bend.what = BendOperation{.below = 1, .metamers = 4, .inclination = -0.2, .iterations = 3};
  return parameters;
}

OrganizeParameters ringed(int iterations, double share) {
  OrganizeParameters parameters = full(iterations);
  TreeOperation& girdle = parameters.operations.emplace_back();
  girdle.when = OperationSchedule::at(8);
  girdle.shoots = branches();
  girdle.what = GirdleOperation{.below = 0, .share = share, .iterations = 3};
  return parameters;
}

TEST(OrganizeBend, TheSameOnAnyNumberOfThreads) {
  const std::string bend = skeleton_hash(grow_organized(bent(13)));
  const std::string girdle = skeleton_hash(grow_organized(ringed(13, 1)));
  EXPECT_NE(bend, skeleton_hash(grow_organized(full(13))));
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(skeleton_hash(grow_organized(bent(13))), bend) << threads;
    EXPECT_EQ(skeleton_hash(grow_organized(ringed(13, 1))), girdle) << threads;
  }
}

TEST(OrganizeBend, ActsNotBeforeItsTime) {
  EXPECT_EQ(grow_organized(bent(7)).position, grow_organized(full(7)).position);
  EXPECT_EQ(grow_organized(ringed(8, 1)).position, grow_organized(full(8)).position);
}

TEST(OrganizeBend, BranchesHangWhereTheyAreBent) {
  // Returns the mean rise of the metamers beyond the bend, over all branches that existed in the bend's iteration.
  const auto mean_rise = [](const OrganizeParameters& parameters) {
    const Skeleton tree = grow_organized(parameters);
    check_skeleton(tree);
    const std::vector<float>& number = tree.extra.find("metamer")->second;
    double sum = 0;
    int count = 0;
    for (NodeIndex node = 1; node < tree.node_count(); ++node) {
      if (tree.order[node] != 1 || number[node] != 5 || tree.birth[node] > 8) continue;
      const Vec3 way = glm::normalize(tree.position[node] - tree.position[tree.parent[node]]);
      sum += std::asin(static_cast<double>(way.y));
      ++count;
    }
    EXPECT_GT(count, 3);
    return sum / count;
  };
  EXPECT_NEAR(mean_rise(bent(10)), -0.2, 0.02);
  EXPECT_GT(mean_rise(full(10)), 0);
}

TEST(OrganizeGirdle, RingedBranchesKeepWhatTheyMake) {
  // No resource is lost: with rings, the root and the branches together have the resource of the root without rings.
  const Skeleton open = grow_organized(ringed(8, 0));
  const Skeleton rings = grow_organized(ringed(8, 1));
  EXPECT_EQ(open.position, rings.position);
  EXPECT_LT(of_seed(rings, "resource"), of_seed(open, "resource"));
  // After its time, the ring has healed: the two following rounds differ only by new growth.
  const Skeleton healed = grow_organized(ringed(11, 1));
  const double light = of_seed(healed, "light");
  EXPECT_NEAR(of_seed(healed, "resource"), 2 * light, 1e-3 * light);
  const Skeleton last = grow_organized(ringed(10, 1));
  EXPECT_LT(of_seed(last, "resource"), 1.9 * of_seed(last, "light"));
}

}  // namespace meristem::tree_bows_test
