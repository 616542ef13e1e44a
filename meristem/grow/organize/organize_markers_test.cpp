// SPDX-License-Identifier: Apache-2.0
// Self-organizing trees that compete for space by markers.
#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/grow/stand_space.h"
#include "meristem/scene/crown/solid_crowns.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/organized_trees.h"

namespace meristem::organize_markers_test {

/// The specification's parameters for markers.
OrganizeParameters among_markers(int iterations) {
  OrganizeParameters parameters = full(iterations);
  parameters.light.kind = BudLightModel::Kind::markers;
  parameters.direction = {.persistence = 0.55, .light = 0.3, .up = 0.15, .up_later = 0, .up_fade = 0.9};
  return parameters;
}

std::vector<Skeleton> grow(Stand& stand) {
  Progress progress;
  stand.grow(progress);
  std::vector<Skeleton> trees = stand.take_skeletons(progress);
  for (const Skeleton& tree : trees) EXPECT_TRUE(check_skeleton(tree));
  return trees;
}

Frame at(float x) { return {.axes = Mat3(1), .origin = {x, 0, 0}}; }

double reach_toward(const Skeleton& tree, Vec3 way) {
  double reach = 0;
  for (const Vec3 position : tree.position) {
    reach = std::max(reach, static_cast<double>(glm::dot(position - tree.position[0], way)));
  }
  return reach;
}

TEST(OrganizeAmongMarkers, SizesStrayLittleFromSeedToSeed) {
  constexpr int kSeeds = 20;
  for (const int iterations : {9, 12}) {
    std::vector<double> counts;
    std::vector<double> heights;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Skeleton tree = grow_organized(among_markers(iterations), seed);
      counts.push_back(metamer_count(tree));
      heights.push_back(reach_toward(tree, kUp));
    }
    const auto mean = [](const std::vector<double>& values) {
      double sum = 0;
      for (const double value : values) sum += value;
      return sum / kSeeds;
    };
    for (int k = 0; k < kSeeds; ++k) {
      EXPECT_NEAR(counts[static_cast<std::size_t>(k)], mean(counts), 0.25 * mean(counts)) << iterations;
      EXPECT_NEAR(heights[static_cast<std::size_t>(k)], mean(heights), 0.25 * mean(heights)) << iterations;
    }
  }
}

TEST(OrganizeAmongMarkers, IsTheSameOnAnyNumberOfThreads) {
  const std::string hash = skeleton_hash(grow_organized(among_markers(11)));
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(skeleton_hash(grow_organized(among_markers(11))), hash) << threads;
  }
}

TEST(OrganizeAmongMarkers, StaysAboutItsRoom) {
  OrganizeParameters parameters = among_markers(14);
  const CrownPointer room = std::make_shared<BoxCrown>(Box{{-4, 0, -4}, {4, 9, 4}});
  Stand stand;
  const Scene scene;
  stand.add(make_organizer(stand, {{Frame(), room}}, parameters, RandomKey(1), scene, {}, "tree"));
  const Skeleton tree = grow(stand)[0];
  const Box box = bounds(tree);
  EXPECT_GT(metamer_count(tree), 50);
  // A bud at the border may still grow its shoot of this iteration.
  const float over = static_cast<float>(parameters.longest_shoot) / 2;
  EXPECT_LT(std::max({box.high.x, box.high.z, -box.low.x, -box.low.z}), 4 + over);
  EXPECT_LT(box.high.y, 9 + over);
  EXPECT_GT(metamer_count(grow_organized(parameters)), 2 * metamer_count(tree));
}

TEST(OrganizeAmongMarkers, NeighboursKeepTheirCrownsApart) {
  const OrganizeParameters parameters = among_markers(13);
  const Skeleton alone = grow_organized(parameters, 1);
  Stand stand;
  const Scene scene;
  add_organizer(stand, parameters, 1, scene, at(0));
  add_organizer(stand, parameters, 2, scene, at(8));
  const std::vector<Skeleton> trees = grow(stand);
  // There is less space toward the neighbour than away from it.
  EXPECT_LT(reach_toward(trees[0], {1, 0, 0}), 0.8 * reach_toward(alone, {1, 0, 0}));
  EXPECT_LT(reach_toward(trees[0], {1, 0, 0}), 0.8 * reach_toward(trees[0], {-1, 0, 0}));
  EXPECT_LT(reach_toward(trees[1], {-1, 0, 0}), 0.8 * reach_toward(trees[1], {1, 0, 0}));
}

TEST(OrganizeAmongMarkers, ObstaclesTakeRoom) {
  Scene scene;
  scene.obstacles = Obstacles({Obstacle{.mesh = box_mesh({2, -1, -30}, {40, 40, 30})}});
  const Skeleton tree = grow_organized(among_markers(12), 1, scene);
  EXPECT_GT(metamer_count(tree), 50);
  for (const Vec3 position : tree.position) EXPECT_LE(position.x, 2);
  EXPECT_GT(reach_toward(tree, {-1, 0, 0}), 5);
}

TEST(OrganizeAmongMarkers, WhatIsCutGivesItsRoomBack) {
  // The leader is cut low and never grows again, so the branches below find its space.
  OrganizeParameters parameters = among_markers(12);
  const Skeleton whole = grow_organized(parameters, 3);
  parameters.operations = {cut_above(7, "main", 5)};
  const Skeleton cut = grow_organized(parameters, 3);
  const auto above_the_cut = [](const Skeleton& tree) {
    return std::ranges::count_if(tree.position,
                                 [](Vec3 position) { return position.y > 8 && std::abs(position.x) < 3; });
  };
  EXPECT_GT(above_the_cut(whole), 20);
  EXPECT_GT(above_the_cut(cut), 10);
}

TEST(OrganizeAmongMarkers, CountedMarkersAreWorthMoreThanAny) {
  OrganizeParameters parameters = among_markers(5);
  parameters.light.counts = true;
  parameters.light.full = 0.05;
  const Skeleton counted = grow_organized(parameters);
  EXPECT_GT(of_seed(counted, "light"), 0);
  parameters.light.counts = false;
  // A twentieth of the light is too little to open a bud that has found space.
  EXPECT_THROW(grow_organized(parameters), InputError);
}

TEST(OrganizeAmongMarkers, ASeedWithoutRoomIsAFault) {
  const CrownPointer room = std::make_shared<BoxCrown>(Box{{20, 0, 20}, {24, 4, 24}});
  Stand stand;
  const Scene scene;
  stand.add(make_organizer(stand, {{Frame(), room}}, among_markers(3), RandomKey(1), scene, {}, "tree"));
  Progress progress;
  EXPECT_THROW(stand.grow(progress), InputError);
}

TEST(OrganizeAmongMarkers, ARootTooFarAwayIsAFault) {
  Stand stand;
  const Scene scene;
  try {
    add_organizer(stand, among_markers(3), 1, scene, at(1e7F));
    FAIL() << "it stands there";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].path, "components.tree.roots");
  }
}

/// Grows a tree in a room above its root.
Skeleton grow_in_room(const CrownPointer& room, std::uint64_t seed, int iterations = 12) {
  const Scene scene;  // the organizer refers to it
  Stand stand;
  stand.add(make_organizer(stand, {{Frame(), room}}, among_markers(iterations), RandomKey(seed), scene, SizeLimits(),
                           "tree"));
  return std::move(grow(stand)[0]);
}

TEST(OrganizeAmongMarkers, ShootsDoNotLeaveTheRoom) {
  const auto box = std::make_shared<BoxCrown>(Box{{-3, 0, -2}, {3, 9, 2}});
  const auto ball = std::make_shared<EllipsoidCrown>(Vec3(0, 5, 0), Vec3(4, 5, 4));
  for (const CrownPointer& room : {CrownPointer(box), CrownPointer(ball)}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Skeleton tree = grow_in_room(room, seed);
      EXPECT_GT(tree.node_count(), 40U) << seed;
      for (NodeIndex node = 1; node < tree.node_count(); ++node) {
        ASSERT_TRUE(room->contains(tree.position[node])) << "seed " << seed << ", node " << node;
      }
    }
  }
}

TEST(OrganizeAmongMarkers, AStemMayGrowIntoARoomAboveIt) {
  const auto room = std::make_shared<EllipsoidCrown>(Vec3(0, 6, 0), Vec3(3, 3, 3));
  const Skeleton tree = grow_in_room(room, 1);
  EXPECT_GT(tree.node_count(), 30U);
  for (NodeIndex node = 1; node < tree.node_count(); ++node) {
    const NodeIndex parent = tree.parent[node];
    const bool stays = room->contains(tree.position[node]);
    EXPECT_TRUE(stays || !room->contains(tree.position[parent])) << node;
    if (stays) continue;
    EXPECT_LT(room->distance(tree.position[node]), room->distance(tree.position[parent])) << node;
  }
}

}  // namespace meristem::organize_markers_test
