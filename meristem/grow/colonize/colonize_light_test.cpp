// SPDX-License-Identifier: Apache-2.0
// Trees among obstacles, in the light, and in the shade of other trees.
#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/grow/colonize/colonize.h"
#include "meristem/scene/crown/crown_points.h"
#include "meristem/scene/crown/solid_crowns.h"
#include "tests/support/check_skeleton.h"

namespace meristem::colonize_light_test {

constexpr double kFar = std::numeric_limits<double>::infinity();
const ColonizeParameters kSmall{
    .step = 0.05, .influence = kFar, .kill = 0.12, .finish = {.decimate = 0, .relax = false, .subdivide = 0}};

std::vector<Vec3> ball_points(Vec3 centre, double radius, std::uint64_t count, std::uint64_t seed = 3) {
  Progress progress;
  return sample_crown(EllipsoidCrown(centre, Vec3(static_cast<float>(radius))), count, RandomKey(seed), progress);
}

std::vector<Skeleton> grow(const std::vector<std::pair<Seedling, ColonizeParameters>>& trees, const Scene& scene) {
  Stand stand;
  for (const auto& [seedling, parameters] : trees) {
    stand.add(make_colonizer(stand, {seedling}, parameters, RandomKey(1), scene, SizeLimits(), "tree", Progress()));
  }
  Progress progress;
  stand.grow(progress);
  return stand.take_skeletons(progress);
}

Skeleton grow(const Scene& scene, const ColonizeParameters& parameters = kSmall, std::uint64_t points = 400) {
  return std::move(grow({{{Vec3(0), ball_points({0, 2, 0}, 1, points)}, parameters}}, scene)[0]);
}

testing::AssertionResult are_same(const Skeleton& a, const Skeleton& b) {
  if (a.parent == b.parent && a.position == b.position && a.radius == b.radius && a.birth == b.birth) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << a.node_count() << " and " << b.node_count() << " nodes";
}

Scene scene_with(TriangleMesh mesh) {
  Scene scene;
  Obstacle obstacle;
  obstacle.mesh = std::move(mesh);
  scene.obstacles = Obstacles({obstacle});
  return scene;
}

// A beam through the crown.
Scene beam() { return scene_with(box_mesh({-2, 1.8, 0.2}, {2, 2.3, 0.6})); }

Scene walled_day() {
  Scene scene = scene_with(box_mesh({-3, 0, 1.4}, {3, 3, 3}));
  scene.light.sun = sun_of_day(radians(51.5), 126, 2);
  return scene;
}

std::string refusal(const Scene& scene) {
  try {
    grow(scene);
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 1U);
    EXPECT_FALSE(error.diagnostics()[0].expected.empty());
    return error.diagnostics()[0].path + ": " + error.diagnostics()[0].message;
  }
  return "";
}

TEST(ColonizeAmongObstacles, NothingGrowsIntoThemOrThroughThem) {
  const Scene scene = beam();
  const Skeleton tree = grow(scene);
  ASSERT_TRUE(check_skeleton(tree));
  ASSERT_GT(tree.node_count(), 300U);
  float highest = 0;
  for (NodeIndex node = 0; node < tree.node_count(); ++node) {
    EXPECT_FALSE(scene.obstacles.contain(tree.position[node]));
    if (!tree.is_root(node)) {
      EXPECT_FALSE(scene.obstacles.cross(tree.position[tree.parent[node]], tree.position[node]));
    }
    highest = std::max(highest, tree.position[node].y);
  }
  EXPECT_GT(highest, 2.7F);  // the tree has grown around the beam
}

TEST(ColonizeAmongObstacles, WhatIsDoneAfterGrowthEntersThemNeither) {
  const Scene scene = beam();
  for (const FinishOptions finish :
       {FinishOptions{}, FinishOptions{.decimate = 10}, FinishOptions{.decimate = 4, .subdivide = 1.5},
        FinishOptions{.relax = false, .subdivide = 3}}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      ColonizeParameters parameters{.step = 0.05, .influence = 0.8, .kill = 0.12, .finish = finish};
      std::vector<Vec3> points = ball_points({0, 2, 0}, 1, 300, seed);
      const Skeleton tree = grow({{{Vec3(0), std::move(points)}, parameters}}, scene)[0];
      ASSERT_TRUE(check_skeleton(tree));
      std::size_t crossing = 0;
      for (NodeIndex node = 0; node < tree.node_count(); ++node) {
        if (tree.is_root(node)) continue;
        crossing += scene.obstacles.cross(tree.position[tree.parent[node]], tree.position[node]) ? 1 : 0;
      }
      EXPECT_EQ(crossing, 0U) << "seed " << seed << ", decimate " << finish.decimate << ", subdivide "
                              << finish.subdivide;
    }
  }
}

TEST(ColonizeAmongObstacles, GrowsTheSameWhereNoneIsNear) {
  const Scene far_away = scene_with(box_mesh({50, 0, 50}, {60, 9, 60}));
  EXPECT_TRUE(are_same(grow(far_away), grow(Scene())));
}

TEST(ColonizeAmongObstacles, RootsInsideAreRefused) {
  EXPECT_EQ(refusal(scene_with(box_mesh({-1, -1, -1}, {1, 0.2, 1}))),
            "components.tree.roots: a root stands inside an obstacle, at (0, 0, 0)");
}

TEST(ColonizeAmongObstacles, RootsMayStandOnThem) {
  const Scene terrace = scene_with(box_mesh({-5, -0.2, -5}, {5, 0, 5}));
  EXPECT_TRUE(are_same(grow(terrace), grow(Scene())));
}

TEST(ColonizeInShade, ItsMemoryIsLimited) {
  SizeLimits limits;
  limits.mesh_bytes = 100'000;
  ColonizeParameters parameters = kSmall;
  parameters.light.shade.emplace();
  parameters.light.shade->form.voxel = 0.02;
  Stand stand;
  const Scene open;
  stand.add(make_colonizer(stand, {{Vec3(0), ball_points({0, 2, 0}, 1, 400)}}, parameters, RandomKey(1), open, limits,
                           "tree", Progress()));
  Progress progress;
  try {
    stand.grow(progress);
    FAIL() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].path, "components.tree.light.shade.voxel");
  }
}

TEST(ColonizeAmongObstacles, CrownsWhollyInsideAreRefused) {
  EXPECT_EQ(refusal(scene_with(box_mesh({-2, 0.5, -2}, {2, 4, 2}))),
            "components.tree.crown: the crown lies wholly inside obstacles");
}

TEST(ColonizeAmongObstacles, AWallBetweenRootAndCrownIsRefused) {
  ColonizeParameters parameters = kSmall;
  parameters.influence = 0.5;
  parameters.kill = 0.12;
  EXPECT_THROW(grow(scene_with(box_mesh({-2, 0.3, -2}, {2, 0.4, 2})), parameters), InputError);
}

TEST(ColonizeInTheLight, GrowsTheSameWithoutAResponse) {
  // The sun alone has no effect, and neither have disabled parts of a response.
  ColonizeParameters parameters = kSmall;
  parameters.light.sunlit_weight = 0.25;
  parameters.light.hold_height = true;
  parameters.light.limit = {.share = 0, .radius = 0.1, .k = 3};
  Scene day;
  day.light.sun = sun_of_day(radians(51.5), 126, 1);
  EXPECT_TRUE(are_same(grow(day, parameters), grow(Scene())));
}

TEST(ColonizeInTheLight, GrowsTheSameIntoACloudThatHardlyMoves) {
  // Moving and resting points use different data structures.
  ColonizeParameters parameters = kSmall;
  parameters.light.shift = 1e-30;
  EXPECT_TRUE(are_same(grow(Scene(), parameters), grow(Scene())));
  parameters.influence = 0.6;
  ColonizeParameters still = kSmall;
  still.influence = 0.6;
  EXPECT_TRUE(are_same(grow(Scene(), parameters), grow(Scene(), still)));
}

TEST(ColonizeInTheLight, IsTheSameOnAnyNumberOfThreads) {
  ColonizeParameters parameters = kSmall;
  parameters.light = {.shift = 0.01, .drift = 0.01, .sunlit_weight = 0.5, .hold_height = true, .limit = {.share = 0.2}};
  parameters.light.shade.emplace();
  const Scene scene = walled_day();
  const auto grow_on = [&](int threads) {
    const ThreadLimit limit(threads);
    return grow(scene, parameters, 1500);
  };
  const Skeleton one = grow_on(1);
  for (const int threads : {2, 3, 8}) EXPECT_TRUE(are_same(grow_on(threads), one));
}

TEST(ColonizeInTheLight, LeansTowardTheSun) {
  Scene scene;
  scene.light.sun = {{unit_vector({radians(90), radians(40)}), 1}};
  ColonizeParameters parameters = kSmall;
  parameters.light.shift = 0.015;
  const Skeleton tree = grow(scene, parameters);
  Vec3 sum(0);
  for (const Vec3 position : tree.position) sum += position;
  EXPECT_GT(sum.x / static_cast<float>(tree.node_count()), 0.2F);
}

TEST(ColonizeInTheLight, FollowsACloudThatRunsAheadOfItsRoot) {
  // The cloud moves away from the root at half the speed of growth: the first kill comes after more than 30 steps.
  Scene scene;
  scene.light.sun = {{kUp, 1}};
  ColonizeParameters parameters = kSmall;
  parameters.light.shift = 0.025;
  EXPECT_GT(grow(scene, parameters).node_count(), 300U);
}

TEST(ColonizeInTheLight, TheSunlitSideOfALimitedCrownStays) {
  Scene scene;
  scene.light.sun = {{unit_vector({radians(180), radians(30)}), 1}};
  ColonizeParameters parameters = kSmall;
  parameters.light.limit = {.share = 0.5, .radius = 0.4, .k = 0.2};
  const auto centre = [](const Skeleton& tree) {
    Vec3 sum(0);
    for (const Vec3 position : tree.position) sum += position;
    return sum / static_cast<float>(tree.node_count());
  };
  EXPECT_GT(centre(grow(scene, parameters)).z, centre(grow(scene)).z + 0.1F);  // to the south
}

// Counts the nodes of a low, slowly growing tree, with or without a tall tree to its south, toward the sun.
std::size_t nodes_of_low_tree(bool feels_shade, bool has_neighbour) {
  ColonizeParameters tall = kSmall;
  tall.influence = 0.5;
  ColonizeParameters low = tall;
  low.step = 0.02;
  if (feels_shade)
    low.light.shade.emplace(ShadeResponse{.bears = 0.5, .form = {.amount = 0.05, .base = 1.3, .depth = 16}});
  Scene scene;
  scene.light.sun = {{unit_vector({radians(180), radians(50)}), 1}};
  std::vector<std::pair<Seedling, ColonizeParameters>> trees;
  trees.emplace_back(Seedling{Vec3(0), ball_points({0, 1.6F, 0}, 1, 400)}, low);
  if (has_neighbour) trees.emplace_back(Seedling{Vec3(0, 0, 1.7F), ball_points({0, 3.8F, 1.7F}, 1.2, 900)}, tall);
  return grow(trees, scene)[0].node_count();
}

TEST(ColonizeInShade, ATallNeighbourStuntsALowTree) {
  const auto in_the_open = static_cast<double>(nodes_of_low_tree(true, false));
  EXPECT_LT(static_cast<double>(nodes_of_low_tree(true, true)), 0.8 * in_the_open);
  EXPECT_GT(static_cast<double>(nodes_of_low_tree(false, true)), 0.95 * in_the_open);
}

TEST(ColonizeInShade, PointsOfOtherTreesCountInTheLimit) {
  ColonizeParameters parameters = kSmall;
  parameters.influence = 0.5;
  parameters.light.limit = {.share = 0.4, .radius = 0.4, .k = 0.2};
  const Seedling low{Vec3(0), ball_points({0, 2, 0}, 1, 400)};
  const Seedling high{Vec3(3, 0, 0), ball_points({0.8F, 5, 0}, 0.8, 800)};
  const auto middle = [](const Skeleton& tree) {
    float sum = 0;
    for (const Vec3 position : tree.position) sum += position.x;
    return sum / static_cast<float>(tree.node_count());
  };
  // The points of the other tree are above one side of the crown.
  EXPECT_LT(middle(grow({{low, parameters}, {high, kSmall}}, Scene())[0]),
            middle(grow({{low, parameters}}, Scene())[0]) - 0.1F);
}

}  // namespace meristem::colonize_light_test
