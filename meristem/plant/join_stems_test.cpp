// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/join_stems.h"

#include <gtest/gtest.h>

#include "meristem/plant/operation_record.h"
#include "tests/support/check_skeleton.h"

namespace meristem::join_stems_test {

/// A straight stem of `segments` segments of 1 m.
Skeleton rod(Vec3 from, Vec3 heading, int segments, float radius) {
  Skeleton skeleton;
  NodeIndex last = skeleton.add_node(kNoNode, from, 0);
  for (int k = 1; k <= segments; ++k) last = skeleton.add_node(last, from + static_cast<float>(k) * heading, 1);
  std::fill(skeleton.radius.begin(), skeleton.radius.end(), radius);
  return skeleton;
}

std::shared_ptr<const Skeleton> shared(Skeleton skeleton) {
  return std::make_shared<const Skeleton>(std::move(skeleton));
}

LooseStem stem(std::string component, Skeleton skeleton) {
  LooseStem loose;
  loose.part.component = std::move(component);
  loose.skeleton = shared(std::move(skeleton));
  return loose;
}

LooseStem child_stem(std::string component, Skeleton skeleton, std::uint32_t parent, NodeIndex node, float along) {
  LooseStem loose = stem(std::move(component), std::move(skeleton));
  loose.parent = parent;
  loose.node = node;
  loose.along = along;
  return loose;
}

/// A trunk of two segments, a bough at 1.5 m, and a twig at the first node of the bough.
std::vector<LooseStem> small_tree() {
  std::vector<LooseStem> stems;
  stems.push_back(stem("trunk", rod({0, 0, 0}, kUp, 2, 0.2F)));
  stems.push_back(child_stem("bough", rod({0, 1.5F, 0}, {1, 0, 0}, 2, 0.1F), 0, 2, 0.5F));
  stems.push_back(child_stem("twig", rod({1, 1.5F, 0}, {0, 0, 1}, 1, 0.05F), 1, 1, 1));
  return stems;
}

TEST(JoinStems, KeepsWhatWasDoneToEachPart) {
  std::vector<LooseStem> stems = small_tree();
  Skeleton bough = *stems[1].skeleton;
  bough.operations.add({.operation = "components.bough.operations[0]", .act = "cut"});
  stems[1].skeleton = shared(std::move(bough));
  const Stem joined = join_stems(std::move(stems))[0];
  ASSERT_EQ(joined.skeleton.operations.size(), 1U);
  EXPECT_EQ(joined.parts[joined.skeleton.operations[0].part].component, "bough");
}

TEST(JoinStems, SkeletonsThatNobodyElseUsesAreMoved) {
  std::vector<LooseStem> stems = small_tree();
  const std::string hash = skeleton_hash(join_stems(std::move(stems))[0].skeleton);
  stems = small_tree();
  stems.push_back(stem("post", {}));
  for (LooseStem& loose : stems) loose.skeleton = loose.own = std::make_shared<Skeleton>(*loose.skeleton);
  *stems[3].own = rod({5, 0, 0}, kUp, 2, 0.1F);
  const Vec3* const memory = stems[3].own->position.data();
  const std::vector<Stem> joined = join_stems(std::move(stems));
  ASSERT_EQ(joined.size(), 2U);
  EXPECT_EQ(skeleton_hash(joined[0].skeleton), hash);
  EXPECT_EQ(joined[1].skeleton.position.data(), memory);
}

TEST(JoinStems, MakesOneSkeletonWithLateralsAtTheirPlaces) {
  const std::vector<Stem> joined = join_stems(small_tree());
  ASSERT_EQ(joined.size(), 1U);
  const Skeleton& tree = joined[0].skeleton;
  check_skeleton(tree);
  // Three nodes of the trunk and one where the bough begins, two nodes of the bough, one of the twig.
  ASSERT_EQ(tree.node_count(), 7U);
  EXPECT_EQ(tree.position[2], Vec3(0, 1.5F, 0));
  EXPECT_EQ(tree.axis, (std::vector<AxisIndex>{0, 0, 0, 0, 1, 1, 2}));
  EXPECT_EQ(tree.order, (std::vector<std::uint16_t>{0, 0, 0, 0, 1, 1, 2}));
  EXPECT_EQ(tree.parent[4], 2U);  // the bough grows from the new node
  EXPECT_EQ(tree.parent[6], 4U);  // the twig grows from the first node of the bough
  EXPECT_EQ(tree.radius[2], 0.2F);
  EXPECT_EQ(joined[0].part(0).component, "trunk");
  EXPECT_EQ(joined[0].part(1).component, "bough");
  EXPECT_EQ(joined[0].part(2).component, "twig");
}

TEST(JoinStems, StemsOnTheSameSegmentSpringInTheirOrderAlongIt) {
  std::vector<LooseStem> stems;
  stems.push_back(stem("trunk", rod({0, 0, 0}, kUp, 1, 0.2F)));
  for (const float along : {0.75F, 0.25F, 0.5F, 0.25F}) {
    stems.push_back(child_stem("bough", rod({0, along, 0}, {1, 0, 0}, 1, 0.1F), 0, 1, along));
  }
  const std::vector<Stem> joined = join_stems(std::move(stems));
  ASSERT_EQ(joined.size(), 1U);
  const Skeleton& tree = joined[0].skeleton;
  check_skeleton(tree);
  float last = -1;
  const SkeletonAxes axes(tree);
  for (const NodeIndex node : axes.of(0)) {
    EXPECT_GE(tree.position[node].y, last);
    last = tree.position[node].y;
  }
  EXPECT_EQ(joined[0].parts.size(), 5U);
  // Two nodes of the trunk, four tips, and three where boughs begin: the two boughs at a quarter share one node.
  EXPECT_EQ(tree.node_count(), 9U);
}

TEST(JoinStems, KeepsApartWhatDoesNotTouchOrHasSeveralRoots) {
  std::vector<LooseStem> stems = small_tree();
  stems[1].skeleton = shared(rod({5, 1.5F, 0}, {1, 0, 0}, 2, 0.1F));  // far from the trunk
  Skeleton two = *stems[2].skeleton;
  two.append(rod({3, 0, 0}, kUp, 1, 0.1F));
  stems[2].skeleton = shared(std::move(two));
  const std::vector<Stem> joined = join_stems(std::move(stems));
  ASSERT_EQ(joined.size(), 3U);
  for (const Stem& each : joined) EXPECT_TRUE(each.part_of_axis.empty());
}

TEST(JoinStems, ExtraColumnsAreMixedAtNewNodesAndZeroWhereUnknown) {
  std::vector<LooseStem> stems = small_tree();
  const auto add_column = [&](std::size_t k, const std::string& name, std::vector<float> values) {
    Skeleton skeleton = *stems[k].skeleton;
    skeleton.extra[name] = std::move(values);
    stems[k].skeleton = shared(std::move(skeleton));
  };
  add_column(0, "light", {0, 0.2F, 0.6F});
  add_column(2, "age", {1, 2});
  const std::vector<Stem> joined = join_stems(std::move(stems));
  const Skeleton& tree = joined[0].skeleton;
  check_skeleton(tree);
  EXPECT_FLOAT_EQ(tree.extra.at("light")[2], 0.4F);
  EXPECT_EQ(tree.extra.at("light")[6], 0);
  EXPECT_EQ(tree.extra.at("age")[6], 2);
  EXPECT_EQ(tree.extra.at("age")[0], 0);
}

TEST(JoinStems, AStemWithoutDaughtersStaysAsItIs) {
  std::vector<LooseStem> stems;
  stems.push_back(stem("trunk", rod({0, 0, 0}, kUp, 3, 0.2F)));
  const std::string hash = skeleton_hash(*stems[0].skeleton);
  EXPECT_EQ(skeleton_hash(join_stems(std::move(stems))[0].skeleton), hash);
}

}  // namespace meristem::join_stems_test
