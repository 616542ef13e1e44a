// SPDX-License-Identifier: Apache-2.0
// Trees among obstacles, in the light, and in the shade of other trees.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/grow/colonize/colonize.h"
#include "meristem/scene/crown/crown_points.h"
#include "meristem/scene/crown/solid_crowns.h"
#include "meristem/scene/field/ready_fields.h"
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

// A tree in a wind along x. `field` is in steps.
struct WindTrial {
  double strength = 1;
  double field = 0.1;
  double gusts = 0;
  std::uint64_t seed = 0;
};

Skeleton grow_in_wind(const WindTrial& trial) {
  static const Scene scene;
  const WindGusts gusts{.share = trial.gusts, .size = 0.5, .drift = 0, .key = RandomKey(trial.seed).child("gusts")};
  const auto wind = std::make_shared<WindField>(Vec3(static_cast<float>(trial.strength), 0, 0), gusts);
  ColonizeParameters parameters = kSmall;
  parameters.influence = 0.6;
  parameters.light.field = trial.field * parameters.step;
  const Directions directions = scene.directions();
  parameters.directions = directions.with(directions.light_sense().with(wind, true), directions.gravity_sense());
  const Seedling seedling{Vec3(0), ball_points({0, 2, 0}, 0.9, 900, trial.seed)};
  return std::move(grow({{seedling, parameters}}, scene)[0]);
}

Vec3 mean_position(const Skeleton& tree) {
  DVec3 sum(0);
  for (const Vec3 position : tree.position) sum += DVec3(position);
  return Vec3(sum / static_cast<double>(tree.node_count()));
}

TEST(ColonizeInTheWind, TheCrownMovesWithTheWindAndItsStrength) {
  int far = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Vec3 calm = mean_position(grow_in_wind({.strength = 0, .seed = seed}));
    float before = 0;
    for (const double strength : {0.2, 0.5, 1.0}) {
      const Vec3 way = mean_position(grow_in_wind({.strength = strength, .seed = seed})) - calm;
      EXPECT_GT(way.x, before) << seed;
      before = way.x;
      const bool is_along = degrees(math::atan2(static_cast<double>(std::abs(way.z)), static_cast<double>(way.x))) < 20;
      if (strength == 1) far += way.x >= 0.15F && is_along ? 1 : 0;
    }
  }
  EXPECT_GE(far, 5);
}

TEST(ColonizeInTheWind, WithoutAFieldThePointsRest) {
  const Skeleton rest = grow_in_wind({.field = 0});
  EXPECT_LT(std::abs(mean_position(rest).x - mean_position(grow_in_wind({.strength = 0, .field = 0})).x), 0.1F);
}

TEST(ColonizeInTheWind, IsTheSameOnAnyNumberOfThreads) {
  const auto grown_on = [](int threads) {
    const ThreadLimit limit(threads);
    return grow_in_wind({.gusts = 1});
  };
  EXPECT_TRUE(are_same(grown_on(1), grown_on(3)));
}

// Returns the unevenness of one side of a crown: the deviation of the outermost nodes of cells across the wind from
// those of neighbouring cells, in metres. `side` is -1 for the windward side and 1 for the leeward side.
double raggedness(const Skeleton& tree, int side) {
  constexpr int kCells = 9;
  constexpr float kCell = 0.18F;
  std::array<std::array<std::optional<float>, kCells>, kCells> outermost;
  for (const Vec3 position : tree.position) {
    const int row = static_cast<int>(std::floor((position.y - 2) / kCell + 0.5F * kCells));
    const int column = static_cast<int>(std::floor(position.z / kCell + 0.5F * kCells));
    if (row < 0 || row >= kCells || column < 0 || column >= kCells) continue;
    std::optional<float>& cell = outermost[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    const float out = static_cast<float>(side) * position.x;
    if (!cell || out > *cell) cell = out;
  }
  double sum = 0;
  int count = 0;
  for (std::size_t row = 2; row + 2 < kCells; ++row) {
    for (std::size_t column = 2; column + 2 < kCells; ++column) {
      const auto here = outermost[row][column];
      const auto left = outermost[row][column - 1];
      const auto right = outermost[row][column + 1];
      const auto below = outermost[row - 1][column];
      const auto above = outermost[row + 1][column];
      if (!here || !left || !right || !below || !above) continue;
      const double off = *here - 0.25 * (*left + *right + *below + *above);
      sum += off * off;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

TEST(ColonizeInTheWind, GustsMakeTheWindwardSideRagged) {
  double even = 0;
  double gusty = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    even += raggedness(grow_in_wind({.seed = seed}), -1);
    gusty += raggedness(grow_in_wind({.gusts = 1, .seed = seed}), -1);
  }
  EXPECT_GT(gusty, 1.5 * even);
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
