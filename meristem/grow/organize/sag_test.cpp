// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/sag.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/organized_trees.h"
#include "tests/support/random_metamers.h"

namespace meristem::sag_test {

constexpr double kGravity = 9.81;
constexpr PipeModel kRod{.tip_radius = 0.01, .exponent = 2, .memory = 1};
constexpr BranchSag kWood{.stiffness = 10, .density = 800, .leaf_mass = 0};

/// Adds a metamer of 0.1 m at the end of the rod's axis.
void lengthen(Metamers& rod, int iteration) {
  const MetamerIndex last = rod.axes[0].last;
  const MetamerIndex made = rod.grow(last, false, iteration);
  rod.tip[made] = rod.tip[last] + 0.1F * rod.heading(last);
}

/// A straight rod that rises from the root by 30 degrees.
const Vec3 kAlongRod{0.86602540378F, 0.5F, 0};

Metamers rod_of(int metamers) {
  Metamers rod(kAlongRod, Vec3(0, 0, 1), RandomKey(1));
  for (int k = 0; k < metamers; ++k) lengthen(rod, k + 1);
  return rod;
}

/// Returns how far the tip of a rod has come down.
double fall(const Metamers& rod) { return 0.1 * static_cast<double>(rod.count() - 1) * kAlongRod.y - rod.tip.back().y; }

double rigidity(const BranchSag& sag, double radius) { return sag.stiffness * 1e9 * kPi / 4 * std::pow(radius, 4); }

/// Returns the deflection by beam theory. Each internode turns by M L / (E I), where M is the moment about its base of
/// everything beyond. For small angles, the lever of the weights and the fall of the turned parts both contain the
/// cosine of the slope.
double deflection(const BranchSag& sag, int metamers, double leaf_at_tip = 0) {
  constexpr double kLength = 0.1;
  const double mass = sag.density * kPi * kRod.tip_radius * kRod.tip_radius * kLength;
  double down = 0;
  for (int beyond = metamers; beyond > 0; --beyond) {
    const double moment = kGravity * kLength * (0.5 * mass * beyond * beyond + leaf_at_tip * beyond);
    down += moment * kLength / rigidity(sag, kRod.tip_radius) * kLength * beyond;
  }
  return 0.75 * down;
}

/// Bends the rod by its load.
void bend(BranchLoad& load, Metamers& rod, int iteration) {
  TreePose pose = load.bend(rod, iteration);
  rod.tip = pose.tip;
  rod.side = pose.side;
  load.take(pose.moment);
}

/// Bends a rod under a load that is applied for the first time.
void bend(const BranchSag& sag, Metamers& rod, int iteration) {
  BranchLoad load(sag, kRod);
  bend(load, rod, iteration);
}

TEST(Sag, ARodBendsAsABeam) {
  for (const int metamers : {1, 5, 12}) {
    Metamers rod = rod_of(metamers);
    bend(kWood, rod, 1000);
    EXPECT_NEAR(fall(rod), deflection(kWood, metamers), 0.01 * deflection(kWood, metamers) + 1e-6);
    EXPECT_NEAR(rod.tip.back().z, 0, 1e-6);
  }
}

TEST(Sag, ASlenderRodApproachesTheTextbooksCantilever) {
  // The textbook value is q L^4 / (8 E I). A chain of turns at the bases differs from it by two thirds over the number
  // of links.
  const int metamers = 60;
  const BranchSag stiff{.stiffness = 1000, .density = 100, .leaf_mass = 0};
  Metamers rod = rod_of(metamers);
  bend(stiff, rod, 1000);
  const double q = stiff.density * kPi * kRod.tip_radius * kRod.tip_radius * kGravity;
  const double textbook = 0.75 * q * std::pow(0.1 * metamers, 4) / (8 * rigidity(stiff, kRod.tip_radius));
  EXPECT_NEAR(fall(rod) / textbook, 1 + 4.0 / 3 / metamers, 0.02);
}

TEST(Sag, LeavesOfTheNewestIterationWeighBesides) {
  BranchSag leafy = kWood;
  leafy.leaf_mass = 0.01;
  const auto down = [&](int iteration) {
    Metamers rod = rod_of(6);
    bend(leafy, rod, iteration);
    return fall(rod);
  };
  EXPECT_NEAR(down(6), deflection(kWood, 6, 0.01), 0.01 * deflection(kWood, 6, 0.01));
  EXPECT_NEAR(down(7), deflection(kWood, 6), 0.01 * deflection(kWood, 6) + 1e-6);
}

TEST(Sag, HalfAsStiffBendsTwiceAsFar) {
  const auto down = [](double stiffness) {
    BranchSag sag = kWood;
    sag.stiffness = stiffness;
    Metamers rod = rod_of(8);
    bend(sag, rod, 1000);
    return fall(rod);
  };
  EXPECT_NEAR(down(5) / down(10), 2, 0.02);
}

TEST(Sag, WithoutMoreLoadNothingBendsFurther) {
  Metamers rod = rod_of(8);
  BranchLoad load(kWood, kRod);
  bend(load, rod, 1000);
  const std::vector<Vec3> bent = rod.tip;
  const double down = fall(rod);
  for (int again = 0; again < 5; ++again) bend(load, rod, 1000);
  for (std::size_t k = 0; k < bent.size(); ++k) EXPECT_LT(glm::distance(rod.tip[k], bent[k]), 0.01 * down);
}

TEST(Sag, LoadThatComesBitByBitBendsByItsIncrements) {
  // A uniform rod, loaded as it grows: each internode turns by the moments added after it.
  Metamers rod = rod_of(1);
  BranchLoad load(kWood, kRod);
  bend(load, rod, 1000);
  for (int k = 2; k <= 8; ++k) {
    lengthen(rod, k);
    bend(load, rod, 1000);
  }
  const auto turned = [](const Metamers& bent, MetamerIndex metamer) {
    return std::asin(bent.heading(metamer - 1).y) - std::asin(bent.heading(metamer).y);
  };
  Metamers at_once = rod_of(8);
  bend(kWood, at_once, 1000);
  for (MetamerIndex metamer = 1; metamer <= 8; ++metamer) {
    EXPECT_NEAR(turned(rod, metamer), turned(at_once, metamer), 0.02 * turned(at_once, 1) + 1e-6) << metamer;
  }
}

TEST(Sag, UprightStemsStayUpright) {
  Metamers stem(kUp, Vec3(1, 0, 0), RandomKey(1));
  for (int k = 0; k < 10; ++k) lengthen(stem, k + 1);
  const std::vector<Vec3> before = stem.tip;
  bend(BranchSag{.stiffness = 0.001}, stem, 10);
  EXPECT_EQ(stem.tip, before);
}

TEST(Sag, FollowsWhatIsRemoved) {
  // The remaining metamers keep their moments: a tree that never bore the removed part bends no further either.
  Metamers rod = rod_of(8);
  for (int k = 0; k < 3; ++k) {
    const MetamerIndex made = rod.grow(k == 0 ? 2 : rod.axes[1].last, k == 0, 9);
    rod.tip[made] = rod.tip[rod.parent[made]] + Vec3(0, 0, 0.1F);
  }
  BranchLoad load(kWood, kRod);
  bend(load, rod, 1000);
  const Vec3 tip = rod.tip[8];
  std::vector<std::uint8_t> gone(rod.count(), 0);
  gone[9] = 1;
  rod.remove(gone, Bud::damaged());
  load.remove(gone);
  bend(load, rod, 1000);
  EXPECT_EQ(rod.count(), 9U);
  // Without the branch, the rod rises a little.
  EXPECT_GT(rod.tip[8].y, tip.y);
  EXPECT_LT(rod.tip[8].y, rod_of(8).tip[8].y);
}

/// A bushy tree with strong bending in each iteration.
Skeleton bent_tree(double stiffness) {
  OrganizeParameters parameters = full(18);
  parameters.length = 0.1;
  parameters.sag = BranchSag{.stiffness = stiffness};
  return grow_organized(parameters);
}

TEST(Sag, NothingComesBelowTheGround) {
  const Skeleton tree = bent_tree(0.01);
  ASSERT_TRUE(check_skeleton(tree));
  for (const Vec3 position : tree.position) EXPECT_GE(position.y, 0);
}

TEST(Sag, InternodesKeepTheirLengths) {
  const Skeleton tree = bent_tree(2);
  for (NodeIndex node = 1; node < tree.node_count(); ++node) {
    if (tree.position[node].y < 0.02F) continue;  // metamers on the ground may be bent there
    EXPECT_NEAR(glm::distance(tree.position[node], tree.position[tree.parent[node]]), 0.1, 1e-4);
  }
}

TEST(Sag, HeavyCrownsAreLowerAndWider) {
  const auto slenderness = [](const Skeleton& tree) {
    const Vec3 size = bounds(tree).size();
    return size.y / std::max(size.x, size.z);
  };
  OrganizeParameters parameters = full(18);
  parameters.length = 0.1;
  EXPECT_LT(slenderness(bent_tree(0.3)), 0.9 * slenderness(grow_organized(parameters)));
}

}  // namespace meristem::sag_test
