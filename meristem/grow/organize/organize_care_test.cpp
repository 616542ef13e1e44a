// SPDX-License-Identifier: Apache-2.0
// Shedding by resource, fruits, stubs, water shoots and the closure of wounds, on whole trees.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/organized_trees.h"

namespace meristem::organize_care_test {

const std::vector<float>& column(const Skeleton& tree, const char* name) { return tree.extra.find(name)->second; }

double sum_of(const Skeleton& tree, const char* name) {
  double sum = 0;
  for (const float value : column(tree, name)) sum += value;
  return sum;
}

/// A tree whose stem is cut in half in iteration 10.
OrganizeParameters halved(int iterations, double stub = 0) {
  OrganizeParameters parameters = full(iterations);
  TreeOperation operation = cut_above(10, "main", 8);
  std::get<CutOperation>(operation.what).stub = stub;
  parameters.operations.push_back(operation);
  return parameters;
}

TEST(OrganizeShedding, ByResourceRemovesWhatTheTreeStarves) {
  OrganizeParameters parameters = full(16);
  const double all = metamer_count(grow_organized(parameters));
  double before = all;
  for (const double below : {0.1, 0.3, 0.6}) {
    parameters.shedding.resource = below;
    const Skeleton tree = grow_organized(parameters);
    EXPECT_TRUE(check_skeleton(tree));
    EXPECT_LT(metamer_count(tree), before) << below;
    before = metamer_count(tree);
  }
  EXPECT_GT(before, 0.05 * all);
  // Light and resource act together: a shoot needs enough of both.
  parameters.shedding = {.below = 0.3, .resource = 0};
  const double by_light = metamer_count(grow_organized(parameters));
  parameters.shedding.resource = 0.6;
  EXPECT_LT(metamer_count(grow_organized(parameters)), by_light);
}

/// Returns the number of fruits in each of the iterations from 10 to 24.
std::vector<double> crops(double cost) {
  std::vector<double> counts;
  for (int iterations = 10; iterations <= 24; ++iterations) {
    OrganizeParameters parameters = full(iterations);
    parameters.bearing = {.cost = cost, .threshold = 0.3, .age = 2};
    counts.push_back(sum_of(grow_organized(parameters), "fruit"));
  }
  return counts;
}

/// Returns how often crops turn from more to fewer or back, as a share of all possible times.
double turns(const std::vector<double>& counts) {
  int found = 0;
  for (std::size_t k = 2; k < counts.size(); ++k) {
    found += (counts[k] - counts[k - 1]) * (counts[k - 1] - counts[k - 2]) < 0 ? 1 : 0;
  }
  return found / static_cast<double>(counts.size() - 2);
}

TEST(OrganizeBearing, CostlyFruitsMakeEveryOtherYearAnOffYear) {
  const std::vector<double> cheap = crops(0);
  const std::vector<double> costly = crops(2);
  EXPECT_GT(turns(costly), 0.8);
  EXPECT_LT(turns(cheap), 0.4);
}

TEST(OrganizeBearing, FruitsCostGrowthAndNothingChangesWithoutCost) {
  OrganizeParameters parameters = full(18);
  const Skeleton bare = grow_organized(parameters);
  parameters.bearing = {.cost = 1, .threshold = 0.3, .age = 2};
  const Skeleton bearing = grow_organized(parameters);
  EXPECT_TRUE(check_skeleton(bearing));
  EXPECT_LT(metamer_count(bearing), metamer_count(bare));
  EXPECT_EQ(bare.extra.count("fruit"), 0U);
  // No bud flowers, so nothing changes.
  parameters.bearing->threshold = 1000;
  EXPECT_EQ(grow_organized(parameters).position, bare.position);
}

TEST(OrganizeStub, StaysAsThickAsWhatWasCut) {
  const Skeleton clean = grow_organized(halved(10));
  const Skeleton tree = grow_organized(halved(10, 0.5));
  EXPECT_TRUE(check_skeleton(tree));
  ASSERT_EQ(tree.node_count(), clean.node_count() + 1);
  const NodeIndex stub = static_cast<NodeIndex>(tree.node_count() - 1);
  const NodeIndex below = tree.parent[stub];
  EXPECT_NEAR(glm::distance(tree.position[stub], tree.position[below]), 0.5, 1e-4);
  EXPECT_EQ(column(tree, "terminal_bud")[stub], 2);
  EXPECT_EQ(column(tree, "lateral_bud")[stub], 3);
  // The wood of the removed part is remembered by the stub, and so by the stem below it.
  EXPECT_GT(tree.radius[stub], 1.5F * static_cast<float>(PipeModel().tip_radius));
  EXPECT_NEAR(tree.radius[0], clean.radius[0], 1e-6);
}

TEST(OrganizeStub, NothingGrowsFromItAndTheBudBelowGoesOn) {
  const Skeleton tree = grow_organized(halved(16, 0.4));
  EXPECT_TRUE(check_skeleton(tree));
  const std::vector<float>& number = column(tree, "metamer");
  int stubs = 0;
  int successors = 0;
  for (NodeIndex node = 1; node < tree.node_count(); ++node) {
    const NodeIndex parent = tree.parent[node];
    if (tree.order[node] == 0 && number[node] == 9) ++stubs;
    if (tree.order[node] == 1 && tree.order[parent] == 0 && number[parent] == 8) ++successors;
    EXPECT_FALSE(tree.order[parent] == 0 && number[parent] == 9) << node;
  }
  EXPECT_EQ(stubs, 1);
  EXPECT_EQ(successors, 1);
}

/// Returns the first metamers of the shoots that the stem has grown since it was cut in iteration 10.
std::vector<NodeIndex> shoots_since_cut(const Skeleton& tree) {
  std::vector<NodeIndex> shoots;
  for (NodeIndex node = 1; node < tree.node_count(); ++node) {
    if (tree.order[node] == 1 && tree.order[tree.parent[node]] == 0 && tree.birth[node] > 10) shoots.push_back(node);
  }
  return shoots;
}

TEST(OrganizeWaterShoots, RiseBelowALargeCut) {
  const auto mean_rise = [](const Skeleton& tree) {
    const std::vector<NodeIndex> shoots = shoots_since_cut(tree);
    double sum = 0;
    for (const NodeIndex node : shoots) sum += tree.position[node].y - tree.position[tree.parent[node]].y;
    return sum / static_cast<double>(shoots.size());
  };
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    OrganizeParameters parameters = halved(12);
    parameters.lateral_threshold = 4;  // a stem with few branches
    const Skeleton plain = grow_organized(parameters, seed);
    parameters.water_shoots = {.threshold = 0.2, .cut = 5, .within = 6, .years = 2, .up = 0};
    const Skeleton level = grow_organized(parameters, seed);
    EXPECT_GT(shoots_since_cut(level).size(), shoots_since_cut(plain).size() + 1) << seed;
    parameters.water_shoots->up = 3;
    const Skeleton steep = grow_organized(parameters, seed);
    EXPECT_TRUE(check_skeleton(steep));
    EXPECT_GT(mean_rise(steep), mean_rise(level)) << seed;
    // A cut that is too small has no water shoots, and neither have buds that are too far away.
    parameters.water_shoots->cut = 100'000;
    EXPECT_EQ(grow_organized(parameters, seed).position, plain.position);
  }
}

TEST(OrganizeWounds, CloseFromTheirEdge) {
  const auto wound = [](int iterations, double closure) {
    OrganizeParameters parameters = halved(iterations);
    parameters.closure = closure;
    const Skeleton tree = grow_organized(parameters);
    return static_cast<double>(*std::ranges::max_element(column(tree, "wound")));
  };
  const double open = wound(10, 0);
  EXPECT_GT(open, 0.004);
  EXPECT_NEAR(wound(14, 0), open, 1e-6);
  EXPECT_NEAR(wound(11, 0.001), open - 0.001, 1e-6);
  EXPECT_NEAR(wound(13, 0.001), open - 0.003, 1e-6);
  EXPECT_EQ(wound(13, 0.1), 0);
  EXPECT_EQ(grow_organized(halved(10)).extra.count("wound"), 0U);
}

TEST(OrganizeCare, IsTheSameOnAnyNumberOfThreads) {
  const auto grown_on = [](int threads) {
    const ThreadLimit limit(threads);
    OrganizeParameters parameters = halved(14, 0.5);
    parameters.bearing = FruitBearing();
    parameters.water_shoots = WaterShoots();
    parameters.closure = 0.001;
    parameters.shedding = {.below = 0.1, .resource = 0.1};
    return grow_organized(parameters);
  };
  const Skeleton one = grown_on(1);
  for (const int threads : {2, 8}) {
    const Skeleton other = grown_on(threads);
    EXPECT_EQ(one.position, other.position);
    EXPECT_EQ(one.radius, other.radius);
    EXPECT_EQ(one.extra, other.extra);
  }
}

}  // namespace meristem::organize_care_test
