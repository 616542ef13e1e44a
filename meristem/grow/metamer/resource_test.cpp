// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/metamer/resource.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/random_metamers.h"

namespace meristem::resource_test {

ResourceFlow divided(const Metamers& metamers, const BudLight& light, const ResourceModel& model, int iteration = 1,
                     double age = 0) {
  ResourceFlow flow;
  gather_light(metamers, light, flow);
  divide_resource(metamers, light, model, iteration, age, flow);
  return flow;
}

ResourceModel priority_model() { return {.division = ResourceModel::Division::priority}; }

/// A stem of `count` metamers on its seed.
Metamers stem(int count) {
  Metamers metamers(kUp, Vec3(1, 0, 0), RandomKey(1));
  for (MetamerIndex k = 0; k < static_cast<MetamerIndex>(count); ++k) metamers.grow(k, false, 1);
  return metamers;
}

/// Equal light for every bud.
BudLight even_light(const Metamers& metamers, float amount = 1) {
  BudLight light;
  light.terminal.assign(metamers.count(), amount);
  light.lateral.assign(metamers.count(), amount);
  return light;
}

/// Returns the resource of all open buds. The share of a terminal bud without light is lost, because the bud does not
/// open.
double given(const Metamers& metamers, const BudLight& light, const ResourceFlow& flow) {
  double sum = 0;
  for (MetamerIndex metamer = 0; metamer < metamers.count(); ++metamer) {
    if (metamers.terminal[metamer].is_open() && light.terminal[metamer] > 0) sum += flow.terminal(metamer);
    if (metamers.lateral[metamer].is_open()) sum += flow.lateral(metamer);
  }
  return sum;
}

/// Returns the light of a bud, or of everything that it has grown.
double light_of(const Metamers& metamers, const BudLight& light, MetamerIndex metamer, bool is_lateral) {
  const Bud bud = (is_lateral ? metamers.lateral : metamers.terminal)[metamer];
  if (bud.is_open()) return (is_lateral ? light.lateral : light.terminal)[metamer];
  if (!bud.is_grown()) return 0;
  return light_of(metamers, light, bud.metamer(), false) + light_of(metamers, light, bud.metamer(), true);
}

int open_buds_of(const Metamers& metamers, MetamerIndex metamer, bool is_lateral) {
  const Bud bud = (is_lateral ? metamers.lateral : metamers.terminal)[metamer];
  if (!bud.is_grown()) return bud.is_open() ? 1 : 0;
  return open_buds_of(metamers, bud.metamer(), false) + open_buds_of(metamers, bud.metamer(), true);
}

TEST(GatherLight, SumsOpenBudsTowardTheRoot) {
  Metamers metamers = stem(3);
  metamers.grow(metamers.grow(2, true, 1), false, 1);
  metamers.terminal[3] = Bud::damaged();
  BudLight light = even_light(metamers, 0.5F);
  ResourceFlow flow;
  gather_light(metamers, light, flow);
  // Open buds: the laterals of metamers 1 and 3, and three of the shoot on 2.
  EXPECT_EQ(flow.buds[0], 5U);
  EXPECT_DOUBLE_EQ(flow.light[0], 2.5);
  EXPECT_EQ(flow.buds[4], 3U);
  EXPECT_DOUBLE_EQ(flow.light[3], 0.5);
}

TEST(PriorityWeights, FallStraightToTheLowestAndStayThere) {
  const PriorityWeights weights{.highest = 1, .lowest = 0.2, .reach = 0.5};
  EXPECT_DOUBLE_EQ(weights(0, 10), 1);
  EXPECT_DOUBLE_EQ(weights(1, 10), 0.84);
  EXPECT_DOUBLE_EQ(weights(4, 10), 0.36);
  for (const std::size_t rank : {5U, 6U, 9U}) EXPECT_DOUBLE_EQ(weights(rank, 10), 0.2);
  const PriorityWeights none{.highest = 3, .lowest = 0.2, .reach = 0};
  EXPECT_EQ(none(0, 1), 3);
  EXPECT_EQ(none(1, 4), 0.2);
}

// A random division for a random tree with damaged, dead and dark buds.
struct AnyCase {
  RandomKey key;
  Metamers metamers;
  BudLight light;
  ResourceModel model;

  explicit AnyCase(RandomKey drawn)
      : key(drawn), metamers(random_metamers(key, static_cast<std::size_t>(key.uniform(0, 0, 150)))) {
    harm_buds(metamers, key.child("harm"), key.uniform(1, 0, 0.4));
    light = random_light(metamers, key.child("light"), key.uniform(2));
    if (key.uniform(3) < 0.5) model.division = ResourceModel::Division::priority;
    model.alpha = key.uniform(4, 0, 5);
    model.alpha0 = key.uniform(5) < 0.5 ? 0 : key.uniform(6, 0, 10);
    const double lambda = key.uniform(7, -0.2, 1.2);  // sometimes at one of the limits
    model.lambda = std::clamp(lambda, 0.0, 1.0);
    model.weights.lowest = key.uniform(8) < 0.3 ? 0 : 0.01;
    model.weights.reach = key.uniform(9);
    model.laterals = static_cast<int>(key.uniform(10, 0, 4));
    model.pass_back = std::clamp(key.uniform(11, -0.2, 1.2), 0.0, 1.0);
  }
};

RC_GTEST_PROP(DivideResource, WhatComesToAForkLeavesItWithWhatWasPassedBack, ()) {
  const AnyCase any{RandomKey(*rc::gen::arbitrary<std::uint64_t>())};
  const ResourceFlow flow = divided(any.metamers, any.light, any.model);
  RC_ASSERT(flow.resource[0] == any.model.alpha0 + any.model.alpha * flow.light[0]);
  for (MetamerIndex metamer = 0; metamer < any.metamers.count(); ++metamer) {
    const double came = flow.resource[metamer];
    const double left = flow.terminal(metamer) + flow.lateral(metamer) - came * flow.passed_back[metamer];
    RC_ASSERT(std::abs(left - came) <= 1e-12 * came);
    for (const bool is_lateral : {false, true}) {
      const Bud bud = (is_lateral ? any.metamers.lateral : any.metamers.terminal)[metamer];
      const double part = is_lateral ? flow.lateral(metamer) : flow.terminal(metamer);
      RC_ASSERT(part >= 0);
      if (bud.is_grown()) RC_ASSERT(flow.resource[bud.metamer()] == part);
    }
  }
}

RC_GTEST_PROP(DivideResource, AllThatIsDividedGoesToOpenBudsOrIsLost, ()) {
  const AnyCase any{RandomKey(*rc::gen::arbitrary<std::uint64_t>())};
  const ResourceFlow flow = divided(any.metamers, any.light, any.model);
  RC_ASSERT(std::isfinite(flow.lost));
  RC_ASSERT(flow.lost >= 0);
  RC_ASSERT(std::abs(given(any.metamers, any.light, flow) + flow.lost - flow.resource[0]) <= 1e-9 * flow.resource[0]);
}

RC_GTEST_PROP(DivideResource, RingsKeepAllThatWouldBeDividedWithoutThem, ()) {
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  const AnyCase any{key};
  ResourceFlow flow = divided(any.metamers, any.light, any.model);
  const double whole = flow.resource[0];
  std::vector<float> ringed(any.metamers.count(), 0);
  for (std::size_t metamer = 1; metamer < ringed.size(); ++metamer) {
    if (key.child("ring").uniform(metamer) < 0.2)
      ringed[metamer] = static_cast<float>(key.child("share").uniform(metamer));
  }
  divide_resource(any.metamers, any.light, any.model, 1, 0, flow, ringed);
  RC_ASSERT(flow.lost >= 0);
  RC_ASSERT(flow.resource[0] >= any.model.alpha0);
  RC_ASSERT(std::abs(given(any.metamers, any.light, flow) + flow.lost - whole) <= 1e-9 * whole);
}

TEST(DivideResource, ARingKeepsAboveItWhatLeavesAboveItMake) {
  const Metamers metamers = stem(4);
  const BudLight light = even_light(metamers);
  const ResourceModel model{.alpha = 2, .lambda = 0.5};
  ResourceFlow flow = divided(metamers, light, model);
  std::vector<float> ringed(metamers.count(), 0);
  // Open buds: one at each of metamers 1 to 4, and the terminal of 4. Three of them are above the ring.
  ringed[3] = 1;
  divide_resource(metamers, light, model, 1, 0, flow, ringed);
  EXPECT_DOUBLE_EQ(flow.resource[0], 2 * 2);
  EXPECT_DOUBLE_EQ(flow.resource[3], flow.terminal(2) + 2 * 3);
  // With two rings, no resource is kept twice.
  ringed = {0, 0, 1, 0.5F, 0};
  divide_resource(metamers, light, model, 1, 0, flow, ringed);
  EXPECT_DOUBLE_EQ(flow.resource[0], 2);
  EXPECT_DOUBLE_EQ(flow.resource[2], flow.terminal(1) + 2 * 4 - 3);
  EXPECT_DOUBLE_EQ(flow.resource[3], flow.terminal(2) + 3);
  // A ring with share 0 has no effect.
  const ResourceFlow without = divided(metamers, light, model);
  divide_resource(metamers, light, model, 1, 0, flow, std::vector<float>(metamers.count(), 0));
  EXPECT_EQ(flow.resource, without.resource);
}

TEST(DivideResource, WhatADamagedTerminalPassesBackStaysAboveTheRing) {
  Metamers metamers = stem(3);
  metamers.terminal[3] = Bud::damaged();
  metamers.lateral[3] = Bud::dead();
  metamers.lateral[2] = Bud::dead();
  const BudLight light = even_light(metamers);
  const ResourceModel model{.alpha = 2, .lambda = 0.5};
  const std::vector<float> ringed{0, 0, 1, 0};
  ResourceFlow flow = divided(metamers, light, model);
  const ResourceFlow without = flow;
  divide_resource(metamers, light, model, 1, 0, flow, ringed);
  // Buds above the ring have no light, so nothing changes.
  EXPECT_EQ(flow.resource, without.resource);
  EXPECT_EQ(flow.lost, without.lost);
}

RC_GTEST_PROP(DivideResource, DamagedAndDeadLateralsGetNothing, ()) {
  const AnyCase any{RandomKey(*rc::gen::arbitrary<std::uint64_t>())};
  const ResourceFlow flow = divided(any.metamers, any.light, any.model);
  for (MetamerIndex metamer = 0; metamer < any.metamers.count(); ++metamer) {
    const Bud bud = any.metamers.lateral[metamer];
    if (!bud.is_open() && !bud.is_grown()) RC_ASSERT(flow.lateral(metamer) == 0);
  }
}

RC_GTEST_PROP(DivideResource, NothingIsLostWhereAllBudsAreOpenAndLit, ()) {
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  const Metamers metamers = random_metamers(key, 100);
  const BudLight light = random_light(metamers, key.child("light"));
  RC_ASSERT(divided(metamers, light, {}).lost == 0);
  RC_ASSERT(divided(metamers, light, priority_model()).lost == 0);
}

RC_GTEST_PROP(DivideResource, BorchertHondaIsTheFormula, ()) {
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  const Metamers metamers = random_metamers(key, 60);
  const BudLight light = random_light(metamers, key.child("light"), 0.3);
  const double lambda = key.uniform(0, 0.1, 0.9);
  const ResourceFlow flow = divided(metamers, light, {.lambda = lambda});
  for (MetamerIndex metamer = 0; metamer < metamers.count(); ++metamer) {
    const double q_m = light_of(metamers, light, metamer, false);
    const double q_l = light_of(metamers, light, metamer, true);
    if (q_m + q_l == 0) continue;
    const double v = flow.resource[metamer];
    const double v_m = v * lambda * q_m / (lambda * q_m + (1 - lambda) * q_l);
    RC_ASSERT(std::abs(flow.terminal(metamer) - v_m) <= 1e-9 * v);
    RC_ASSERT(std::abs(flow.lateral(metamer) - (v - v_m)) <= 1e-9 * v);
  }
}

/// Returns the resource of the terminal bud (first) and of the laterals from the tip down, by equation 4.5 of the
/// source.
std::vector<double> by_priority(const Metamers& metamers, const BudLight& light, const PriorityWeights& weights,
                                const Metamers::Axis& axis, double resource) {
  std::vector<double> gathered{light_of(metamers, light, axis.last, false)};
  std::vector<double> mean{0};
  for (MetamerIndex metamer = axis.last;; metamer = metamers.parent[metamer]) {
    gathered.push_back(light_of(metamers, light, metamer, true));
    mean.push_back(gathered.back() / std::max(1, open_buds_of(metamers, metamer, true)));
    if (metamer == axis.first) break;
  }
  std::vector<std::size_t> ranked{0};
  for (std::size_t k = 1; k < mean.size(); ++k) {
    if (gathered[k] > 0) ranked.push_back(k);
  }
  std::sort(ranked.begin() + 1, ranked.end(), [&](std::size_t a, std::size_t b) { return mean[a] > mean[b]; });
  std::vector<double> parts(gathered.size(), 0);
  double sum = 0;
  for (std::size_t rank = 0; rank < ranked.size(); ++rank) {
    parts[ranked[rank]] = gathered[ranked[rank]] * weights(rank, ranked.size());
    sum += parts[ranked[rank]];
  }
  for (double& part : parts) part *= resource / sum;
  return parts;
}

RC_GTEST_PROP(DivideResource, PriorityIsTheFormulaAlongEachAxis, ()) {
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  const Metamers metamers = random_metamers(key, 60);
  const BudLight light = random_light(metamers, key.child("light"), 0.2);
  ResourceModel model = priority_model();
  model.weights = {.highest = 2, .lowest = 0.05, .reach = key.uniform(0, 0.2, 1)};
  const ResourceFlow flow = divided(metamers, light, model);
  for (const Metamers::Axis& axis : metamers.axes) {
    const double resource = flow.resource[axis.first];
    if (!(flow.light[axis.first] > 0)) continue;
    const std::vector<double> wanted = by_priority(metamers, light, model.weights, axis, resource);
    RC_ASSERT(std::abs(flow.terminal(axis.last) - wanted[0]) <= 1e-9 * resource);
    std::size_t k = 1;
    for (MetamerIndex metamer = axis.last;; metamer = metamers.parent[metamer]) {
      RC_ASSERT(std::abs(flow.lateral(metamer) - wanted[k++]) <= 1e-9 * resource);
      if (metamer == axis.first) break;
    }
  }
}

TEST(DivideResource, PriorityFavoursTheLeaderOverItsLaterals) {
  const Metamers metamers = stem(6);
  const BudLight light = even_light(metamers);
  const ResourceFlow fork_by_fork = divided(metamers, light, {.lambda = 0.5});
  const ResourceFlow by_rank = divided(metamers, light, priority_model());
  EXPECT_GT(by_rank.terminal(6), 3 * fork_by_fork.terminal(6));
}

TEST(DivideResource, ChangesToBorchertHondaAfterItsIterations) {
  const Metamers metamers = random_metamers(RandomKey(4), 80);
  const BudLight light = random_light(metamers, RandomKey(5));
  ResourceModel model = priority_model();
  const auto priority = divided(metamers, light, model).resource;
  const auto borchert_honda = divided(metamers, light, {}).resource;
  ASSERT_NE(priority, borchert_honda);
  model.until = 8;
  EXPECT_EQ(divided(metamers, light, model, 8).resource, priority);
  EXPECT_EQ(divided(metamers, light, model, 9).resource, borchert_honda);
}

TEST(DivideResource, ChangesToBorchertHondaOnAxesWithManyLaterals) {
  // A stem with three shoots; the lowest has one shoot of its own.
  Metamers metamers = stem(6);
  const MetamerIndex lowest = metamers.grow(1, true, 1);
  for (const MetamerIndex from : {3U, 4U, lowest}) metamers.grow(from, true, 1);
  const BudLight light = random_light(metamers, RandomKey(5));
  ResourceModel model = priority_model();
  const ResourceFlow priority = divided(metamers, light, model);
  const ResourceFlow borchert_honda = divided(metamers, light, {});
  model.laterals = 3;
  EXPECT_EQ(divided(metamers, light, model).resource, priority.resource);
  model.laterals = 2;
  const ResourceFlow both = divided(metamers, light, model);
  for (MetamerIndex metamer = 0; metamer < metamers.count(); ++metamer) {
    const ResourceFlow& wanted = metamers.axis[metamer] == 0 ? borchert_honda : priority;
    EXPECT_EQ(both.to_lateral[metamer], wanted.to_lateral[metamer]);
  }
}

RC_GTEST_PROP(DivideResource, TheTerminalSideOfEveryForkGetsMoreWithLambda, ()) {
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  const Metamers metamers = random_metamers(key, 80);
  const BudLight light = random_light(metamers, key.child("light"));
  const double low = key.uniform(0, 0, 0.99);
  const ResourceFlow less = divided(metamers, light, {.lambda = low});
  const ResourceFlow more = divided(metamers, light, {.lambda = low + 0.01});
  for (MetamerIndex metamer = 1; metamer < metamers.count(); ++metamer) {
    RC_ASSERT(more.to_lateral[metamer] < less.to_lateral[metamer]);
  }
}

TEST(DivideResource, LambdaFollowsItsCurveOverTheAge) {
  const Metamers metamers = stem(3);
  const BudLight light = even_light(metamers);
  const ResourceModel model{.lambda = 0.8, .lambda_curve = Curve({{0, 1}, {1, 0.5}}, CurveKind::linear)};
  EXPECT_EQ(divided(metamers, light, model, 1, 0).resource, divided(metamers, light, {.lambda = 0.8}).resource);
  EXPECT_EQ(divided(metamers, light, model, 1, 1).resource, divided(metamers, light, {.lambda = 0.4}).resource);
  const ResourceModel beyond{.lambda = 0.8, .lambda_curve = Curve({{0, 2}})};
  EXPECT_EQ(divided(metamers, light, beyond).resource, divided(metamers, light, {.lambda = 1}).resource);
}

/// A stem of three with a damaged terminal bud, for different shares passed back.
struct CutStem {
  Metamers metamers = stem(3);
  BudLight light = even_light(metamers);
  CutStem() { metamers.terminal[3] = Bud::damaged(); }
  ResourceFlow flow(double pass_back) const { return divided(metamers, light, {.pass_back = pass_back}); }
};

TEST(PassBack, LateralsTakeHalfAQuarterAndAnEighthFromTheTopDown) {
  const CutStem cut;
  const ResourceFlow none = cut.flow(0);
  const ResourceFlow half = cut.flow(0.5);
  const double claim = none.terminal(3);
  ASSERT_GT(claim, 0.1);
  EXPECT_DOUBLE_EQ(none.lost, claim);
  EXPECT_NEAR(half.lateral(3) - none.lateral(3), claim / 2, 1e-12);
  EXPECT_NEAR(half.lateral(2) - none.lateral(2), claim / 4, 1e-12);
  EXPECT_NEAR(half.lateral(1) - none.lateral(1), claim / 8, 1e-12);
  EXPECT_NEAR(half.lost, claim / 8, 1e-12);
}

TEST(PassBack, AShareOfAllGoesToTheTopmostLateral) {
  const CutStem cut;
  const ResourceFlow all = cut.flow(1);
  EXPECT_NEAR(all.lateral(3), cut.flow(0).lateral(3) + cut.flow(0).terminal(3), 1e-12);
  EXPECT_EQ(all.lateral(2), cut.flow(0).lateral(2));
  EXPECT_EQ(all.lost, 0);
}

TEST(PassBack, DamagedLateralsOnTheWayTakeNothing) {
  CutStem cut;
  cut.metamers.lateral[3] = Bud::damaged();
  cut.metamers.lateral[1] = Bud::dead();
  const ResourceFlow none = cut.flow(0);
  const ResourceFlow half = cut.flow(0.5);
  EXPECT_EQ(half.lateral(3), 0);
  EXPECT_EQ(half.lateral(1), 0);
  EXPECT_NEAR(half.lateral(2) - none.lateral(2), none.terminal(3) / 2, 1e-12);
  EXPECT_NEAR(half.lost, none.terminal(3) / 2, 1e-12);
}

TEST(PassBack, ABranchOnTheWayTakesItsShareForAllItsBuds) {
  CutStem cut;
  cut.metamers.grow(2, true, 1);
  cut.light = even_light(cut.metamers);
  const ResourceFlow none = cut.flow(0);
  const ResourceFlow half = cut.flow(0.5);
  EXPECT_NEAR(half.resource[4] - none.resource[4], none.terminal(3) / 4, 1e-12);
  EXPECT_NEAR(half.terminal(4) + half.lateral(4), half.resource[4], 1e-12);
}

TEST(PassBack, OfABranchStaysOnTheBranch) {
  Metamers metamers = stem(3);
  metamers.grow(metamers.grow(2, true, 1), false, 1);
  metamers.terminal[5] = Bud::damaged();
  const BudLight light = even_light(metamers);
  const ResourceFlow flow = divided(metamers, light, {});
  for (MetamerIndex on_stem = 0; on_stem <= 3; ++on_stem) EXPECT_EQ(flow.passed_back[on_stem], 0);
  EXPECT_GT(flow.passed_back[4], 0);
  EXPECT_GT(flow.lost, 0);
}

TEST(DivideResource, WhatComesToADarkTreeIsLost) {
  const Metamers metamers = random_metamers(RandomKey(4), 50);
  for (const auto division : {ResourceModel::Division::borchert_honda, ResourceModel::Division::priority}) {
    const BudLight darkness = even_light(metamers, 0);
    const ResourceFlow flow = divided(metamers, darkness, {.division = division, .alpha0 = 3});
    EXPECT_EQ(flow.lost, 3);
    EXPECT_EQ(given(metamers, darkness, flow), 0);
    for (const double resource : flow.resource) EXPECT_TRUE(std::isfinite(resource));
  }
}

TEST(DivideResource, TheOtherSideOfADarkOneGetsAll) {
  const Metamers metamers = stem(1);
  for (const double lambda : {0.0, 0.5, 1.0}) {
    BudLight light = even_light(metamers, 0);
    light.lateral[1] = 0.3F;
    EXPECT_EQ(divided(metamers, light, {.lambda = lambda}).lateral(1), 0.3F * 2.0);
    light = even_light(metamers, 0);
    light.terminal[1] = 0.3F;
    EXPECT_EQ(divided(metamers, light, {.lambda = lambda}).terminal(1), 0.3F * 2.0);
  }
}

}  // namespace meristem::resource_test
