// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/axis_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "meristem/base/random.h"
#include "meristem/plant/finish.h"
#include "meristem/plant/join_stems.h"
#include "meristem/plant/shed.h"

namespace meristem::axis_labels_test {

using Labels = std::vector<std::string>;
using Numbers = std::vector<std::uint32_t>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Adds a node on `axis`, one metre from its parent.
NodeIndex grow(Skeleton& skeleton, NodeIndex parent, AxisIndex axis) {
  const Vec3 base = parent == kNoNode ? Vec3(0) : skeleton.position[parent];
  const NodeIndex node = skeleton.add_node(parent, base + Vec3(axis, 1, 0), 0);
  skeleton.axis[node] = axis;
  const bool goes_on = parent == kNoNode || skeleton.axis[parent] == axis;
  skeleton.order[node] = parent == kNoNode ? 0 : skeleton.order[parent] + (goes_on ? 0 : 1);
  skeleton.radius[node] = 0.1F;
  return node;
}

/// A stem of a root and five metamers, a branch of three from the fourth, and a twig from the second of the branch.
Skeleton small_tree() {
  Skeleton skeleton;
  NodeIndex node = grow(skeleton, kNoNode, 0);
  for (int k = 0; k < 5; ++k) node = grow(skeleton, node, 0);
  node = grow(skeleton, 4, 1);
  for (int k = 0; k < 2; ++k) node = grow(skeleton, node, 1);
  grow(skeleton, 7, 2);
  return skeleton;
}

TEST(AxisLabels, ArePathsOfTheNumbersAtWhichAxesBranchOff) {
  const Skeleton tree = small_tree();
  EXPECT_EQ(axis_numbers(tree), (Numbers{0, 1, 2, 3, 4, 5, 1, 2, 3, 1}));
  EXPECT_EQ(axis_labels(tree), (Labels{"main", "main.4", "main.4.2"}));
}

TEST(AxisLabels, ALateralOnTheRootIsOfNumberZero) {
  Skeleton skeleton;
  grow(skeleton, kNoNode, 0);
  grow(skeleton, 0, 1);
  EXPECT_EQ(axis_labels(skeleton), (Labels{"main", "main.0"}));
}

TEST(AxisLabels, TakeTheNumbersOfMetamersWhereTheyAreKnown) {
  Skeleton tree = small_tree();
  tree.extra["metamer"] = {0, 1, 2, 3, 8, 9, 1, 5, 6, 1};
  EXPECT_EQ(axis_labels(tree), (Labels{"main", "main.8", "main.8.5"}));
  tree.extra["metamer"] = {kNan, -1, 2.5F, 1e9F, 8, 0, 1, 5, 6, 1};
  EXPECT_EQ(axis_numbers(tree), (Numbers{0, 1, 2, 3, 8, 9, 1, 5, 6, 1})) << "what is no number is counted on";
}

TEST(AxisLabels, StayWithAxesWhenOthersAreShed) {
  Skeleton tree;
  NodeIndex node = grow(tree, kNoNode, 0);
  for (int k = 0; k < 5; ++k) node = grow(tree, node, 0);
  grow(tree, 2, 1);
  grow(tree, 4, 2);
  tree.extra["metamer"] = {0, 1, 2, 3, 4, 5, 1, 1};
  EXPECT_EQ(axis_labels(tree), (Labels{"main", "main.2", "main.4"}));
  std::vector<std::uint8_t> marked(tree.node_count(), 0);
  marked[6] = 1;
  EXPECT_EQ(axis_labels(shed_branches(tree, marked)), (Labels{"main", "main.4"}));
}

TEST(AxisLabels, SeveralFromOneNumberHaveLettersInTheOrderOfTheAxes) {
  Skeleton skeleton;
  grow(skeleton, kNoNode, 0);
  grow(skeleton, 0, 0);
  for (AxisIndex axis = 1; axis <= 28; ++axis) grow(skeleton, 1, axis);
  const Labels labels = axis_labels(skeleton);
  EXPECT_EQ(labels[1], "main.1");
  EXPECT_EQ(labels[2], "main.1b");
  EXPECT_EQ(labels[26], "main.1z");
  EXPECT_EQ(labels[27], "main.1aa");
  EXPECT_EQ(labels[28], "main.1ab");
}

TEST(AxisLabels, NodesOfOneMetamerShareItsLetters) {
  Skeleton tree = small_tree();
  tree.extra["metamer"] = {0, 1, 1, 2, 2, 3, 1, 2, 3, 1};
  grow(tree, 3, 3);
  EXPECT_EQ(axis_labels(tree), (Labels{"main", "main.2", "main.2.2", "main.2b"}));
}

TEST(AxisLabels, DifferWithinATreeWhateverItsShape) {
  const RandomKey key(3);
  for (std::uint64_t tree = 0; tree < 20; ++tree) {
    Skeleton skeleton;
    grow(skeleton, kNoNode, 0);
    AxisIndex axes = 1;
    std::vector<bool> goes_on(300, false);
    for (std::uint64_t k = 1; k < 300; ++k) {
      const auto parent = static_cast<NodeIndex>(key.child(tree).uniform(k, 0, static_cast<double>(k)));
      const bool is_lateral = goes_on[parent] || key.child(tree).uniform(1000 + k, 0, 1) < 0.3;
      grow(skeleton, parent, is_lateral ? axes++ : skeleton.axis[parent]);
      if (!is_lateral) goes_on[parent] = true;
    }
    const Labels labels = axis_labels(skeleton);
    EXPECT_EQ(labels.size(), axes);
    EXPECT_EQ(std::set<std::string>(labels.begin(), labels.end()).size(), labels.size());
  }
}

TEST(AxisLabels, EveryTreeOfAForestHasItsMain) {
  Skeleton forest = small_tree();
  forest.append(small_tree());
  EXPECT_EQ(axis_labels(forest), (Labels{"main", "main.4", "main.4.2", "main", "main.4", "main.4.2"}));
  EXPECT_TRUE(axis_labels(Skeleton()).empty());
}

TEST(AxisLabels, StayWhereNodesAreAddedBetween) {
  Skeleton tree = small_tree();
  tree.extra["metamer"] = {0, 1, 2, 3, 4, 5, 1, 2, 3, 1};
  const Skeleton finer = subdivide(tree, 0.3);
  ASSERT_GT(finer.node_count(), 2 * tree.node_count());
  for (const float metamer : finer.extra.find(kMetamerColumn)->second) EXPECT_EQ(metamer, std::floor(metamer));
  // A child that begins within the fourth metamer is a lateral of that metamer.
  std::vector<LooseStem> stems(2);
  stems[0].skeleton = std::make_shared<Skeleton>(tree);
  auto child = std::make_shared<Skeleton>();
  grow(*child, kNoNode, 0);
  grow(*child, 0, 0);
  child->position = {Vec3(0, 4.5F, 0), Vec3(1, 4.5F, 0)};
  stems[1] = {.part = {}, .skeleton = child, .parent = 0, .node = 4, .along = 0.5F};
  const std::vector<Stem> joined = join_stems(std::move(stems));
  ASSERT_EQ(joined.size(), 1U);
  const Labels labels = axis_labels(joined[0].skeleton);
  EXPECT_EQ(std::set<std::string>(labels.begin(), labels.end()),
            (std::set<std::string>{"main", "main.4", "main.4b", "main.4.2"}));
}

TEST(AxisLabels, NamesOfShootsAreThoseOfTheirOwnPartWhereStemsAreJoined) {
  // A tree with a lateral on its root stands on the second metamer of another tree.
  Skeleton guest = small_tree();
  grow(guest, 0, 3);
  for (Vec3& position : guest.position) position += Vec3(0, 2, 0);
  std::vector<LooseStem> stems(2);
  stems[0].skeleton = std::make_shared<Skeleton>(small_tree());
  stems[1] = {.part = {}, .skeleton = std::make_shared<Skeleton>(guest), .parent = 0, .node = 2};
  const std::vector<Stem> joined = join_stems(std::move(stems));
  ASSERT_EQ(joined.size(), 1U);
  const std::vector<ShootName> names = shoot_names(joined[0].skeleton, joined[0].part_of_axis);
  std::vector<std::pair<std::uint32_t, std::string>> seen;
  for (const ShootName& name : names) {
    seen.emplace_back(name.part, name.label);
    EXPECT_EQ(name.tree, 0U);
  }
  std::ranges::sort(seen);
  EXPECT_EQ(
      seen,
      (std::vector<std::pair<std::uint32_t, std::string>>{
          {0, "main"}, {0, "main.4"}, {0, "main.4.2"}, {1, "main"}, {1, "main.0"}, {1, "main.4"}, {1, "main.4.2"}}));
  const std::vector<std::string> whole = axis_labels(joined[0].skeleton);
  EXPECT_NE(std::ranges::find(whole, "main.2.4.2"), whole.end()) << "the labels of the whole go on from the parent";
}

TEST(AxisLabels, ShootsOfAForestAreNamedTreeByTree) {
  Skeleton forest = small_tree();
  forest.append(small_tree());
  const std::vector<ShootName> names = shoot_names(forest, {});
  ASSERT_EQ(names.size(), 6U);
  EXPECT_EQ(names[4], (ShootName{0, 1, "main.4"}));
  EXPECT_EQ(shoot_nodes(forest, 4), (std::vector<NodeIndex>{14, 16, 17, 18}));
  EXPECT_EQ(shoot_nodes(forest, 0), (std::vector<NodeIndex>{0, 1, 2, 3, 4, 5}));
}

}  // namespace meristem::axis_labels_test
