// SPDX-License-Identifier: Apache-2.0
// Seasons, plans, records and supports of the scene, on whole trees.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/plant/axis_labels.h"
#include "meristem/plant/operation_record.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/organized_trees.h"

namespace meristem::organize_upkeep_test {

OrganizeParameters with(OrganizeParameters parameters, TreeOperation operation) {
  operation.path = "components.tree.operations[" + std::to_string(parameters.operations.size()) + "]";
  parameters.operations.push_back(std::move(operation));
  return parameters;
}

TreeOperation shorten_branches(int at, bool in_summer) {
  TreeOperation operation;
  operation.when = OperationSchedule::at(at);
  operation.when.in_summer = in_summer;
  const std::string text = "rank == 1 && length > 2";
  operation.shoots = {ShootChoice::Kind::condition, text, Expression::compile(text, {shoot_variables(), {}})};
  CutOperation cut;
  cut.above = 2;
  operation.what = cut;
  return operation;
}

double born_in(const Skeleton& tree, int iteration) {
  return static_cast<double>(std::ranges::count(tree.birth, static_cast<float>(iteration)));
}

/// Returns the names of the shoots that grew in an iteration.
std::set<std::string> shoots_of(const Skeleton& tree, int iteration) {
  const std::vector<std::string> labels = axis_labels(tree);
  std::set<std::string> born;
  for (NodeIndex node = 1; node < tree.node_count(); ++node) {
    const bool begins = tree.axis[node] != tree.axis[tree.parent[node]];
    if (begins && tree.birth[node] == static_cast<float>(iteration)) born.insert(labels[tree.axis[node]]);
  }
  return born;
}

TEST(OrganizeSeasons, ASummerCutIsAnsweredInItsIteration) {
  int answers = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const OrganizeParameters strong = organized(2.6, 8);
    const std::set<std::string> wild = shoots_of(grow_organized(strong, seed), 8);
    const auto new_shoots = [&](bool in_summer) {
      const Skeleton tree = grow_organized(with(strong, shorten_branches(8, in_summer)), seed);
      EXPECT_TRUE(check_skeleton(tree));
      EXPECT_FALSE(tree.operations.empty());
      const std::set<std::string> born = shoots_of(tree, 8);
      return std::ranges::count_if(born, [&](const std::string& shoot) { return wild.count(shoot) == 0; });
    };
    answers += static_cast<int>(new_shoots(true));
    EXPECT_EQ(new_shoots(false), 0) << "after a winter cut nothing grows before the next iteration";
  }
  EXPECT_GE(answers, 10);
}

TEST(OrganizeSeasons, ASummerWithoutAnythingToDoGrowsAsManyMetamers) {
  double with_summer = 0, without = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    TreeOperation nothing = shorten_branches(1, true);
    nothing.shoots.condition = Expression::compile("length > 1000", {shoot_variables(), {}});
    const auto count = [&](int from) {
      nothing.when = {.from = from, .in_summer = true};
      return metamer_count(grow_organized(with(full(12), nothing), seed));
    };
    const double free = metamer_count(grow_organized(full(12), seed));
    EXPECT_EQ(count(12), free) << "in one iteration";
    // Shoots that sense the light once more turn a little, so different buds open in later iterations.
    with_summer += count(1);
    without += free;
  }
  EXPECT_NEAR(with_summer / without, 1, 0.1);
}

TEST(OrganizeSeasons, UntilItsFirstSummerTheTreeIsTheSame) {
  const Skeleton plain = grow_organized(full(9));
  EXPECT_EQ(grow_organized(with(full(9), shorten_branches(10, true))).position, plain.position);
  const Skeleton longer = grow_organized(with(full(10), shorten_branches(10, true)));
  EXPECT_NE(longer.position, grow_organized(full(10)).position);
  EXPECT_GT(born_in(longer, 10), 0);
}

TEST(OrganizeSeasons, TheSameBytesOnAnyNumberOfThreads) {
  for (const auto kind : {BudLightModel::Kind::shadow, BudLightModel::Kind::markers}) {
    OrganizeParameters parameters = with(full(10), shorten_branches(7, true));
    parameters.light.kind = kind;
    std::string hash;
    for (const int threads : {1, 2, 3, 8}) {
      const ThreadLimit limit(threads);
      const std::string own = skeleton_hash(grow_organized(parameters));
      if (hash.empty()) hash = own;
      EXPECT_EQ(own, hash) << threads;
    }
  }
}

TEST(OrganizeRecords, WhatIsCutAndWhatIsLeftIsAllThatGrew) {
  // There are no other losses, so the cut metamers are the difference.
  const Skeleton whole = grow_organized(full(10));
  const Skeleton cut = grow_organized(with(full(10), shorten_branches(10, false)));
  double metamers = 0;
  for (const OperationRecord& record : cut.operations) metamers += record.metamers;
  EXPECT_GT(metamers, 0);
  EXPECT_EQ(metamer_count(whole), metamer_count(cut) + metamers);
  // The columns of the remaining tree have equal sums.
  double in_columns = 0;
  for (const float count : cut.extra.find("cut_metamers")->second) in_columns += count;
  EXPECT_EQ(in_columns, metamers);
}

TEST(OrganizeRecords, StandWhereTheTreeStands) {
  const OrganizeParameters parameters = with(full(8), shorten_branches(8, false));
  const Frame away{.origin = Vec3(5, 1, -3)};
  const Skeleton near = grow_organized(parameters), far = grow_organized(parameters, 1, {}, away);
  ASSERT_EQ(near.operations.size(), far.operations.size());
  for (std::size_t k = 0; k < near.operations.size(); ++k) {
    EXPECT_LT(glm::distance(near.operations[k].position + away.origin, far.operations[k].position), 1e-4F);
    EXPECT_EQ(near.operations[k].shoot, far.operations[k].shoot);
  }
}

TEST(OrganizeCallus, AStemThatIsCutBackAgainAndAgainGrowsAHead) {
  OrganizeParameters parameters = organized(3, 24);
  parameters.radii = {.tip_radius = 0.01, .exponent = 2, .memory = 0};
  TreeOperation head = cut_above(5, "main", 8);
  TreeOperation pollard;
  pollard.when = {.from = 8, .every = 3};
  const std::string text = "rank >= 1";
  pollard.shoots = {ShootChoice::Kind::condition, text, Expression::compile(text, {shoot_variables(), {}})};
  pollard.what = SpurOperation{2};
  parameters = with(with(parameters, head), pollard);
  const Skeleton plain = grow_organized(parameters);
  parameters.callus = 0.5;
  const Skeleton swollen = grow_organized(parameters);
  ASSERT_EQ(swollen.position, plain.position);
  // The wood swells most at the cut, hardly near the ground, and not at all in young wood.
  const auto gain = [&](NodeIndex node) { return swollen.radius[node] / plain.radius[node]; };
  NodeIndex max = 0;
  for (NodeIndex node = 0; node < plain.node_count(); ++node) max = gain(node) > gain(max) ? node : max;
  EXPECT_GT(gain(max), 1.3F);
  EXPECT_GT(plain.extra.find("cut_at")->second[max], 0);
  EXPECT_LT(gain(1), 1.05F);
  for (NodeIndex node = 0; node < plain.node_count(); ++node) {
    EXPECT_GE(gain(node), 1) << node;
    if (plain.birth[node] == 24) {
      EXPECT_EQ(gain(node), 1) << node;
    }
  }
}

TEST(OrganizePlan, TellsWhatWouldBeDoneAndDoesNothing) {
  OrganizeParameters parameters = with(full(10), shorten_branches(10, false));
  // The second operation sees the tree after the first one.
  TreeOperation second = shorten_branches(10, false);
  CutOperation closer;
  closer.above = 1;
  second.what = closer;
  const std::string text = "rank == 1 && length > 1";
  second.shoots.condition = Expression::compile(text, {shoot_variables(), {}});
  parameters = with(parameters, second);
  const Skeleton done = grow_organized(parameters);
  parameters.plans = true;
  const Skeleton planned = grow_organized(parameters);
  EXPECT_EQ(planned.operations, done.operations);
  EXPECT_FALSE(planned.operations.empty());
  const Skeleton wild = grow_organized(full(10));
  EXPECT_EQ(planned.position, wild.position);
  EXPECT_EQ(planned.extra.find("light")->second, wild.extra.find("light")->second);
}

TEST(OrganizePlan, KeepsWhatWasDoneBeforeAndBendsNothing) {
  OrganizeParameters parameters = with(full(10), shorten_branches(7, false));
  TreeOperation bend = shorten_branches(10, false);
  bend.what = BendOperation{.metamers = 2, .inclination = -0.5};
  parameters = with(parameters, bend);
  const Skeleton before = [&] {
    OrganizeParameters shorter = parameters;
    shorter.operations.pop_back();
    return grow_organized(shorter);
  }();
  parameters.plans = true;
  const Skeleton planned = grow_organized(parameters);
  EXPECT_EQ(planned.position, before.position);
  for (const OperationRecord& record : planned.operations) EXPECT_EQ(record.act, "bend");
  EXPECT_FALSE(planned.operations.empty());
  EXPECT_EQ(planned.extra.find("cut_at")->second, before.extra.find("cut_at")->second);
}

/// Returns the trees of a stand after their growth, and after their planned operations if these were recorded.
std::pair<Skeleton, std::optional<Skeleton>> grow_all(const OrganizeParameters& parameters,
                                                      const std::vector<Vec3>& roots) {
  std::vector<OrganizeSeed> seeds(roots.size());
  for (std::size_t k = 0; k < roots.size(); ++k) seeds[k].frame.origin = roots[k];
  const Scene scene;
  Stand stand;
  stand.add(make_organizer(stand, seeds, parameters, RandomKey(1), scene, {}, "tree"));
  Progress progress;
  stand.grow(progress);
  const auto traces = stand.take_traces(progress);
  std::optional<Skeleton> outcome;
  if (traces[0] != nullptr && traces[0]->outcome() != nullptr) outcome = *traces[0]->outcome();
  return {std::move(stand.take_skeletons(progress)[0]), std::move(outcome)};
}

/// Returns the trees of a stand before and after their planned operations, from one growth.
std::pair<Skeleton, Skeleton> planned_and_done(OrganizeParameters parameters, const std::vector<Vec3>& roots) {
  parameters.plans = true;
  parameters.request = {TracePart::outcome};
  auto [before, outcome] = grow_all(parameters, roots);
  EXPECT_TRUE(outcome);
  return {std::move(before), outcome.value()};
}

TEST(OrganizePlan, ItsOutcomeHasTheBytesOfAGrowthThatDoesIt) {
  const std::vector<Vec3> roots{Vec3(0), Vec3(4, 0, 0)};
  for (const auto kind : {BudLightModel::Kind::shadow, BudLightModel::Kind::markers}) {
    for (const int every : {1, 3}) {
      OrganizeParameters parameters = with(full(9), shorten_branches(6, false));
      parameters.light.kind = kind;
      parameters.every = every;
      parameters.sag.emplace();
      parameters.shedding.below = 0.05;
      parameters.callus = 0.2;
      TreeOperation bend = shorten_branches(9, false);
      bend.what = BendOperation{.metamers = 2, .inclination = -0.5};
      parameters = with(with(parameters, bend), shorten_branches(9, false));
      const auto [planned, outcome] = planned_and_done(parameters, roots);
      const Skeleton done = grow_all(parameters, roots).first;
      EXPECT_EQ(skeleton_hash(outcome), skeleton_hash(done)) << every;
      EXPECT_EQ(outcome.extra, done.extra) << every;
      EXPECT_EQ(outcome.operations, done.operations);
      EXPECT_GT(planned.node_count(), outcome.node_count());
      // Requesting the outcome does not change the plan.
      parameters.plans = true;
      const Skeleton only_planned = grow_all(parameters, roots).first;
      EXPECT_EQ(skeleton_hash(planned), skeleton_hash(only_planned));
      EXPECT_EQ(planned.extra, only_planned.extra);
      EXPECT_EQ(planned.operations, only_planned.operations);
    }
  }
}

TEST(OrganizePlan, NobodyElseFeelsItsOutcome) {
  // A neighbouring tree continues to grow while the other records its outcome.
  const auto neighbour = [](bool requests) {
    OrganizeParameters parameters = with(full(9), cut_above(9, "main", 2));
    parameters.plans = true;
    if (requests) parameters.request = {TracePart::outcome};
    const Scene scene;
    Stand stand;
    add_organizer(stand, parameters, 1, scene);
    add_organizer(stand, full(14), 2, scene, Frame{.origin = Vec3(2, 0, 0)});
    Progress progress;
    stand.grow(progress);
    stand.take_traces(progress);
    return skeleton_hash(stand.take_skeletons(progress)[1]);
  };
  EXPECT_EQ(neighbour(true), neighbour(false));
}

TEST(OrganizePlan, ItsSkeletonSaysWhatEachOperationWouldCut) {
  OrganizeParameters parameters = with(full(10), shorten_branches(10, false));
  parameters = with(parameters, cut_above(10, "main", 9));
  parameters.operations[0].number = 4;  // numbers differ from indices if the list has disabled operations
  parameters.operations[1].number = 7;
  parameters.plans = true;
  const Skeleton tree = grow_organized(parameters);
  const std::vector<float>& plan_cut = tree.extra.at("plan_cut");
  const auto count_of = [&](float number) { return std::ranges::count(plan_cut, number); };
  double metamers = 0;
  for (const OperationRecord& record : tree.operations) metamers += record.metamers;
  EXPECT_GT(count_of(4), 0);
  EXPECT_GT(count_of(7), 0);
  EXPECT_EQ(count_of(0) + metamers, tree.node_count());
  parameters.plans = false;
  const Skeleton done = grow_organized(parameters);
  EXPECT_EQ(done.node_count(), static_cast<std::size_t>(count_of(0)));
  EXPECT_EQ(done.extra.count("plan_cut"), 0U);
}

TEST(OrganizeRecords, TellTheDiameterAtTheCutAndTheBudOnTheBark) {
  OrganizeParameters parameters = with(full(10), shorten_branches(10, false));
  parameters.plans = true;
  const Frame away{.origin = Vec3(5, 1, -3)};
  const Skeleton tree = grow_organized(parameters, 1, {}, away);
  const std::vector<std::string> labels = axis_labels(tree);
  const std::vector<float>& number = tree.extra.at("metamer");
  std::size_t found = 0;
  for (const OperationRecord& record : tree.operations) {
    for (NodeIndex node = 1; node < tree.node_count(); ++node) {
      if (labels[tree.axis[node]] != record.shoot) continue;
      if (number[node] == static_cast<float>(record.metamer)) {
        EXPECT_EQ(tree.position[node], record.position);
        const float bark = glm::distance(record.position, record.bud_position);
        EXPECT_NEAR(bark, record.bud == Vec3(0) ? 0 : tree.radius[node], 1e-5);
        EXPECT_GE(glm::dot(record.bud_position - record.position, record.bud), 0.999F * bark);
      }
      if (number[node] != static_cast<float>(record.metamer + 1)) continue;
      EXPECT_NEAR(record.diameter, 2 * tree.radius[node], 1e-6);
      ++found;
    }
  }
  EXPECT_EQ(found, tree.operations.size());
  EXPECT_GT(found, 0U);
}

TEST(OrganizeSupports, EaseJitter) {
  // Only jitter turns the stem: fully without support, by a fifth with a support of weight 4.
  const auto turn = [](double weight) {
    OrganizeParameters parameters = full(16);
    parameters.direction = {.light = 0, .up = 0};
    parameters.phyllotaxis.jitter = radians(10);
    TreeOperation operation;
    operation.shoots = ShootChoice::leader();
    operation.what = TrainingSupport{.line = {Vec3(0), Vec3(0, 100, 0)}, .weight = weight};
    parameters = with(parameters, operation);
    double squares = 0;
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Skeleton tree = grow_organized(parameters, seed);
      for (NodeIndex node = 2; node < tree.node_count(); ++node) {
        const NodeIndex parent = tree.parent[node];
        if (tree.axis[node] != 0 || parent == 0) continue;
        const Vec3 way = glm::normalize(tree.position[node] - tree.position[parent]);
        const Vec3 before = glm::normalize(tree.position[parent] - tree.position[tree.parent[parent]]);
        const double angle = degrees(std::acos(std::min(1.0F, glm::dot(way, weight > 0 ? kUp : before))));
        squares += angle * angle;
        ++count;
      }
    }
    EXPECT_GT(count, 100);
    return std::sqrt(squares / count);
  };
  EXPECT_NEAR(turn(0), 10, 1);
  EXPECT_NEAR(turn(4), 2, 0.6);
}

TEST(OrganizeSupports, OfTheSceneAreTheirsWhereverTheRootIs) {
  TreeOperation operation;
  operation.shoots = ShootChoice::leader();
  operation.what = TrainingSupport{.named = "wire", .weight = 8};
  const OrganizeParameters parameters = with(full(14), operation);
  Scene scene;
  scene.supports["wire"] = {Vec3(2, 0, 0), Vec3(2, 20, 0)};
  const Skeleton tree = grow_organized(parameters, 1, scene);
  NodeIndex tip = 0;
  for (NodeIndex node = 0; node < tree.node_count(); ++node) tip = tree.axis[node] == 0 ? node : tip;
  EXPECT_NEAR(tree.position[tip].x, 2, 0.7);
  EXPECT_NEAR(tree.position[tip].z, 0, 0.7);
  try {
    scene.supports = {{"wires", {Vec3(0), Vec3(0, 1, 0)}}};
    grow_organized(parameters, 1, scene);
    ADD_FAILURE() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].path, "components.tree.operations[0].named");
    EXPECT_EQ(error.diagnostics()[0].nearest, "wires");
  }
}

TEST(OrganizeTie, DrawsABranchTowardTheGround) {
  TreeOperation tie;
  tie.when = OperationSchedule::at(8);
  const std::string text = "rank == 1 && length > 2";
  tie.shoots = {ShootChoice::Kind::condition, text, Expression::compile(text, {shoot_variables(), {}})};
  tie.what = TieOperation{.length = 1};
  const Skeleton free = grow_organized(full(8));
  OrganizeParameters parameters = full(8);
  parameters.radii.tip_radius = 0.01;
  const Skeleton tied = grow_organized(with(parameters, tie));
  ASSERT_TRUE(check_skeleton(tied));
  ASSERT_FALSE(tied.operations.empty());
  ASSERT_EQ(tied.parent, free.parent);
  double lower = 0;
  for (NodeIndex node = 0; node < tied.node_count(); ++node) {
    lower += free.position[node].y - tied.position[node].y;
    if (tied.axis[node] != 0) continue;
    EXPECT_EQ(tied.position[node], free.position[node]);
  }
  EXPECT_GT(lower, 1);
}

TEST(OrganizeTie, TiesAndMarksAreTheSameOnAnyNumberOfThreads) {
  TreeOperation tie = shorten_branches(6, false);
  tie.when = {.from = 6, .every = 2};
  tie.what = TieOperation{.length = 1, .iterations = 2};
  TreeOperation mark = shorten_branches(5, false);
  mark.when = {.from = 5};
  mark.what = MarkOperation{.chance = 0.5};
  OrganizeParameters parameters = with(with(full(12), tie), mark);
  parameters.radii.tip_radius = 0.01;
  parameters.marks = {"dead"};
  const std::vector<Vec3> roots{Vec3(0), Vec3(3, 0, 0), Vec3(0, 0, 3)};
  Skeleton first;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    const Skeleton tree = grow_all(parameters, roots).first;
    if (threads == 1) first = tree;
    EXPECT_EQ(skeleton_hash(tree), skeleton_hash(first)) << threads;
    EXPECT_EQ(tree.extra, first.extra) << threads;
    EXPECT_EQ(tree.operations, first.operations) << threads;
  }
  const auto acts = [&](const char* act) { return std::ranges::count(first.operations, act, &OperationRecord::act); };
  EXPECT_GT(acts("tie"), 0);
  EXPECT_GT(acts("mark"), 0);
}

}  // namespace meristem::organize_upkeep_test
