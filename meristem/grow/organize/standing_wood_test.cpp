// SPDX-License-Identifier: Apache-2.0
// Skeletons as metamers, and trees that continue from them.
#include "meristem/grow/organize/standing_wood.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/organized_trees.h"

namespace meristem::standing_wood_test {

/// A stem of `nodes` equal internodes up to a height.
Skeleton stem(int nodes, float height) {
  Skeleton wood;
  wood.add_node(kNoNode, Vec3(0), 0);
  for (int k = 1; k <= nodes; ++k) {
    const auto part = static_cast<float>(k) / static_cast<float>(nodes);
    wood.add_node(static_cast<NodeIndex>(k - 1), Vec3(0, height * part, 0), 0);
  }
  wood.radius.assign(wood.node_count(), 0.1F);
  return wood;
}

void add_lateral(Skeleton& wood, NodeIndex parent, Vec3 end, float radius = 0.05F) {
  const NodeIndex node = wood.add_node(parent, end, 0);
  AxisIndex axes = 0;
  for (const AxisIndex axis : wood.axis) axes = std::max(axes, axis);
  wood.axis[node] = axes + 1;
  wood.order[node] = static_cast<std::uint16_t>(wood.order[parent] + 1);
  wood.radius[node] = radius;
}

/// Checks that each bud grows once, that the seed has no lateral bud, and that bearing metamers come first.
void expect_sound(const std::vector<WoodMetamer>& wood) {
  std::set<std::pair<MetamerIndex, bool>> grown;
  for (std::size_t k = 0; k < wood.size(); ++k) {
    EXPECT_LE(wood[k].from, k);
    EXPECT_FALSE(wood[k].from == 0 && wood[k].is_lateral);
    EXPECT_TRUE(grown.insert({wood[k].from, wood[k].is_lateral}).second) << k;
  }
}

Skeleton go_on(const OrganizeParameters& parameters, const Skeleton& wood, const Scene& scene = {},
               const SizeLimits& limits = {}) {
  Stand stand;
  const OrganizeSeed seed{Frame{}, nullptr, std::make_shared<const Skeleton>(wood)};
  stand.add(make_organizer(stand, {seed}, parameters, RandomKey(1), scene, limits, "tree"));
  Progress progress;
  stand.grow(progress);
  return std::move(stand.take_skeletons(progress)[0]);
}

TEST(StandingWood, LongInternodesArePartedAndShortOnesJoined) {
  for (const int nodes : {1, 3, 10, 100}) {
    const std::vector<WoodMetamer> wood = metamers_of_wood(stem(nodes, 10), 1);
    expect_sound(wood);
    EXPECT_NEAR(static_cast<double>(wood.size()), 10, 1) << nodes;
    EXPECT_EQ(wood.back().tip, Vec3(0, 10, 0));
    EXPECT_LE(static_cast<double>(wood.size()), max_metamers_of_wood(stem(nodes, 10), 1));
  }
}

TEST(StandingWood, EachLateralHasABudOfItsOwn) {
  Skeleton wood = stem(2, 2);
  for (const Vec3 end : {Vec3(1, 1, 0), Vec3(-1, 1, 0), Vec3(0, 1, 1), Vec3(0, 1, -1)}) add_lateral(wood, 1, end);
  const std::vector<WoodMetamer> metamers = metamers_of_wood(wood, 1);
  expect_sound(metamers);
  EXPECT_EQ(metamers.size(), 2U + 4U + 3U) << "three short ones bear what the node's own bud cannot";
  int laterals = 0;
  for (const WoodMetamer& metamer : metamers) {
    if (!metamer.is_lateral) continue;
    ++laterals;
    EXPECT_LT(glm::distance(metamers[metamer.from - 1].tip, Vec3(0, 1, 0)), 0.2F);
  }
  EXPECT_EQ(laterals, 4);
}

TEST(StandingWood, StemsOfOneRootStandOnTheThickest) {
  Skeleton wood;
  wood.radius[wood.add_node(kNoNode, Vec3(0), 0)] = 0.3F;
  wood.axis[0] = 0;
  add_lateral(wood, 0, Vec3(1, 1, 0), 0.1F);
  add_lateral(wood, 0, Vec3(0, 1, 0), 0.2F);
  add_lateral(wood, 0, Vec3(-1, 1, 0), 0.1F);
  const std::vector<WoodMetamer> metamers = metamers_of_wood(wood, 2);
  expect_sound(metamers);
  ASSERT_FALSE(metamers.empty());
  EXPECT_EQ(metamers[0].from, 0U);
  EXPECT_EQ(metamers[0].tip.x, 0) << "toward the thickest stem";
}

TEST(StandingWood, WithoutIterationsATreeIsWhatItWas) {
  OrganizeParameters parameters = full(12);
  const Skeleton before = grow_organized(parameters);
  parameters.iterations = 0;
  const Skeleton after = go_on(parameters, before);
  EXPECT_TRUE(check_skeleton(after));
  EXPECT_EQ(after.parent, before.parent);
  EXPECT_EQ(after.position, before.position);
  EXPECT_EQ(after.axis, before.axis);
  EXPECT_EQ(after.radius, before.radius);
  for (const char* const column : {"terminal_bud", "lateral_bud", "metamer", "light"}) {
    EXPECT_EQ(after.extra.at(column), before.extra.at(column)) << column;
  }
}

TEST(StandingWood, ATreeGoesOnAsIfNothingHadHappened) {
  OrganizeParameters parameters = full(8);
  const Skeleton young = grow_organized(parameters);
  parameters.iterations = 6;
  const Skeleton gone_on = go_on(parameters, young);
  EXPECT_TRUE(check_skeleton(gone_on));
  parameters.iterations = 14;
  const Skeleton at_once = grow_organized(parameters);
  EXPECT_NEAR(metamer_count(gone_on), metamer_count(at_once), 0.02 * metamer_count(at_once));
  EXPECT_NEAR(gone_on.radius[0], at_once.radius[0], 0.02 * at_once.radius[0]);
  for (NodeIndex node = 0; node < young.node_count(); ++node) {
    ASSERT_EQ(gone_on.position[node], young.position[node]);
    ASSERT_EQ(gone_on.birth[node], 0);
    ASSERT_GE(gone_on.radius[node], young.radius[node]);
  }
}

TEST(StandingWood, WhatWasCutStaysAsItWasLeft) {
  OrganizeParameters parameters = full(12);
  parameters.operations = {cut_above(8, "main", 5)};
  const Skeleton cut = grow_organized(parameters);
  parameters.operations.clear();
  parameters.iterations = 0;
  const Skeleton after = go_on(parameters, cut);
  EXPECT_EQ(after.parent, cut.parent);
  EXPECT_EQ(after.axis, cut.axis) << "a lateral beside a cut terminal bud stays a lateral";
  EXPECT_EQ(after.extra.at("terminal_bud"), cut.extra.at("terminal_bud"));
}

TEST(StandingWood, MeasuredRadiiGrowByTheTipsThatTheyGain) {
  const Skeleton measured = stem(10, 10);  // much thicker than its one tip requires
  OrganizeParameters parameters = full(6);
  const Skeleton tree = go_on(parameters, measured);
  ASSERT_GT(tree.node_count(), measured.node_count());
  EXPECT_GT(tree.radius[0], 0.1F);
  const double gained = std::pow(tree.radius[0], parameters.radii.exponent) - std::pow(0.1, parameters.radii.exponent);
  const double tips = count_tips(tree.parent, {})[0] - 1;
  EXPECT_NEAR(gained, tips * std::pow(parameters.radii.tip_radius, parameters.radii.exponent), 1e-3 * gained);
}

TEST(StandingWood, WhatStandsBendsByNewLoadAlone) {
  OrganizeParameters parameters = full(10);
  const Skeleton before = grow_organized(parameters);
  parameters.sag.emplace();
  parameters.sag->stiffness = 10;
  parameters.iterations = 1;
  parameters.resource.alpha = 0;  // no resource, so no growth
  const Skeleton after = go_on(parameters, before);
  ASSERT_EQ(after.node_count(), before.node_count());
  for (NodeIndex node = 0; node < before.node_count(); ++node) {
    ASSERT_LT(glm::distance(after.position[node], before.position[node]), 1e-3F) << node;
  }
}

TEST(StandingWood, CutsAndSheddingTakeItToo) {
  OrganizeParameters parameters = full(10);
  const Skeleton before = grow_organized(parameters);
  parameters.iterations = 4;
  parameters.operations = {cut_above(1, "main", 3)};
  const Skeleton cut = go_on(parameters, before);
  EXPECT_TRUE(check_skeleton(cut));
  EXPECT_LT(bounds(cut).high.y, bounds(before).high.y);
  EXPECT_EQ(cut.position[1], before.position[1]);
}

TEST(StandingWood, CastsItsShadeFromTheFirstRoundOn) {
  // A seed under an existing crown has less light than a free-standing one.
  OrganizeParameters parameters = full(10);
  const Skeleton crown = grow_organized(parameters);
  parameters.iterations = 1;
  const Scene scene;
  Stand stand;
  Frame beside;
  beside.origin = Vec3(1, 0, 0);
  stand.add(make_organizer(stand, {{Frame{}, nullptr, std::make_shared<const Skeleton>(crown)}, {beside, nullptr}},
                           parameters, RandomKey(1), scene, SizeLimits(), "tree"));
  Progress progress;
  stand.grow(progress);
  const Skeleton both = std::move(stand.take_skeletons(progress)[0]);
  EXPECT_TRUE(check_skeleton(both));
  NodeIndex second = 1;
  while (!both.is_root(second)) ++second;
  const float shaded = both.extra.at("light")[second];
  EXPECT_LT(shaded, 0.9F * static_cast<float>(of_seed(grow_organized(parameters), "light")));
}

TEST(StandingWood, IsTheSameOnAnyNumberOfThreads) {
  const Skeleton young = grow_organized(full(14));
  std::string first;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const std::string hash = skeleton_hash(go_on(full(6), young));
    if (first.empty()) first = hash;
    EXPECT_EQ(hash, first) << threads;
  }
}

TEST(StandingWood, IsCountedBeforeItIsMade) {
  SizeLimits limits;
  limits.nodes = 1000;
  try {
    go_on(full(1), stem(1, 1e6), {}, limits);
    ADD_FAILURE() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().at(0).path, "components.tree.length");
    EXPECT_NE(error.diagnostics()[0].text().find("nodes"), std::string::npos);
  }
}

}  // namespace meristem::standing_wood_test
