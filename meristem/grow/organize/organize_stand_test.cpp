// SPDX-License-Identifier: Apache-2.0
// Self-organizing trees among other plants: shade, and light and space that become free again.
#include <algorithm>
#include <functional>
#include <memory>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/grow/colonize/colonize.h"
#include "meristem/grow/stand_space.h"
#include "meristem/scene/crown/crown_points.h"
#include "meristem/scene/crown/solid_crowns.h"
#include "tests/support/check_skeleton.h"
#include "tests/support/organized_trees.h"

namespace meristem::organize_stand_test {

std::vector<Skeleton> grow(Stand& stand) {
  Progress progress;
  stand.grow(progress);
  std::vector<Skeleton> trees = stand.take_skeletons(progress);
  for (const Skeleton& tree : trees) EXPECT_TRUE(check_skeleton(tree));
  return trees;
}

Frame at(float x) { return {.axes = Mat3(1), .origin = {x, 0, 0}}; }

/// A roof of leaves over the ground that appears after one round and disappears after another.
class PassingRoof : public Grower {
 public:
  PassingRoof(Stand& stand, int comes, int goes, float height)
      : space_(stand.commons<StandSpace>()), comes_(comes), goes_(goes), height_(height) {}
  int step_limit() const override { return goes_ + 1; }
  bool step(Progress&) override { return round_ < goes_; }
  void tell() override {
    if (round_ == comes_) {
      for_each_leaf([&](Vec3 position) { space_.grow_shoot(position, 3); });
    }
    if (round_ == goes_) {
      for_each_leaf([&](Vec3 position) { space_.lose_shoot(position, 3); });
    }
    ++round_;
  }
  Skeleton take_skeleton(Progress&) override { return {}; }

 private:
  void for_each_leaf(const std::function<void(Vec3)>& visit) const {
    for (int x = -8; x <= 8; ++x) {
      for (int z = -8; z <= 8; ++z) visit({x + 0.1F, height_, z + 0.3F});
    }
  }
  StandSpace& space_;
  int comes_;
  int goes_;
  float height_;
  int round_ = 0;
};

/// Returns the hash of a tree that grows in rounds 0, 5, 10, ... under a roof.
std::string hash_under_roof(int comes, int goes) {
  OrganizeParameters parameters = full(10);
  parameters.every = 5;
  Stand stand;
  const Scene scene;
  stand.add(std::make_unique<PassingRoof>(stand, comes, goes, 6.0F));
  add_organizer(stand, parameters, 1, scene);
  return skeleton_hash(grow(stand)[1]);
}

TEST(OrganizeInAStand, WhatIsGoneGivesItsLightBack) {
  const std::string alone = skeleton_hash(grow_organized(full(10)));
  // The roof exists only between two iterations in the first case, and during an iteration in the other cases.
  EXPECT_EQ(hash_under_roof(6, 9), alone);
  EXPECT_EQ(hash_under_roof(20, 24), alone);
  EXPECT_NE(hash_under_roof(19, 21), alone);
}

float length_of(const Skeleton& tree, NodeIndex node) {
  return tree.is_root(node) ? 0 : glm::distance(tree.position[node], tree.position[tree.parent[node]]);
}

/// Computes the shade of the current metamers.
ShadowGrid shade_of(const Skeleton& tree, const ShadowParameters& form) {
  ShadowGrid grid(form);
  for (NodeIndex node = 0; node < tree.node_count(); ++node) {
    grid.add(tree.position[node], length_of(tree, node) / form.voxel);
  }
  return grid;
}

/// Returns the light of the open buds at each node and beyond it, in a given shade.
std::vector<float> light_in(const ShadowGrid& shade, const Skeleton& tree) {
  std::vector<double> light(tree.node_count(), 0);
  for (auto node = static_cast<NodeIndex>(tree.node_count()); node-- > 0;) {
    const double own = shade.form().amount * length_of(tree, node) / shade.form().voxel;
    const auto left = static_cast<float>(std::clamp(1 - (shade.shade(tree.position[node]) - own), 0.0, 1.0));
    for (const char* bud : {"terminal_bud", "lateral_bud"}) {
      if (tree.extra.find(bud)->second[node] == 0) light[node] += left;
    }
    if (!tree.is_root(node)) light[tree.parent[node]] += light[node];
  }
  return {light.begin(), light.end()};
}

TEST(OrganizeInAStand, ShadeIsThatOfTheMetamersThatAreThere) {
  // The grids are bitwise equal after growth, cuts, shedding and bending, strong or weak.
  const ShadowParameters form{.voxel = 1};
  const Scene scene;
  for (const double stiffness : {0.05, 500.0}) {
    OrganizeParameters parameters = full(18);
    parameters.operations = {cut_above(8, "main", 9), cut_above(13, "main", 6)};
    parameters.shedding.below = 0.2;
    parameters.sag = BranchSag{.stiffness = stiffness};
    Stand stand;
    const ShadowGrid& felt = stand.commons<StandSpace>().shade(form, SizeLimits().mesh_bytes, "light.voxel");
    add_organizer(stand, parameters, 1, scene);
    Progress progress;
    stand.grow(progress);
    const ShadowGrid left = felt;
    const Skeleton tree = stand.take_skeletons(progress)[0];
    ASSERT_GT(metamer_count(tree), 100);
    const ShadowGrid wanted = shade_of(tree, form);
    for (const Vec3 position : tree.position) {
      for (int below = -1; below <= 4; ++below) {
        const Vec3 asked = position - static_cast<float>(below) * kUp;
        ASSERT_EQ(left.shade(asked), wanted.shade(asked));
      }
    }
    EXPECT_EQ(left.bytes(), wanted.bytes());
    const std::vector<float> light = light_in(wanted, tree);
    for (NodeIndex node = 0; node < tree.node_count(); ++node) {
      ASSERT_FLOAT_EQ(tree.extra.find("light")->second[node], light[node]);
    }
  }
}

TEST(OrganizeInAStand, NeighboursTakeLightFromEachOther) {
  const Scene scene;
  const auto metamers = [&](float apart) {
    Stand stand;
    add_organizer(stand, full(16), 1, scene, at(0));
    add_organizer(stand, full(16), 2, scene, at(apart));
    return metamer_count(grow(stand)[0]);
  };
  EXPECT_EQ(metamers(500), metamer_count(grow_organized(full(16), 1)));
  EXPECT_LT(metamers(3), 0.9 * metamers(500));
}

TEST(OrganizeInAStand, NobodyIsServedFirst) {
  const Scene scene;
  Stand one;
  add_organizer(one, full(14), 1, scene, at(0));
  add_organizer(one, slim(14), 2, scene, at(3));
  Stand other;
  add_organizer(other, slim(14), 2, scene, at(3));
  add_organizer(other, full(14), 1, scene, at(0));
  const auto first = grow(one);
  const auto second = grow(other);
  EXPECT_EQ(skeleton_hash(first[0]), skeleton_hash(second[1]));
  EXPECT_EQ(skeleton_hash(first[1]), skeleton_hash(second[0]));
}

TEST(OrganizeInAStand, TreesOfOneComponentCompeteAsThoseOfTwo) {
  const Scene scene;
  Stand one;
  one.add(make_organizer(one, {{at(0), nullptr}, {at(3), nullptr}}, full(12), RandomKey(1), scene, {}, "tree"));
  Stand two;
  for (std::uint64_t k = 0; k < 2; ++k) {
    // Tree keys are children of their component's key, so the keys of two members differ. Only counts are compared.
    add_organizer(two, full(12), 1 + k, scene, at(3.0F * static_cast<float>(k)));
  }
  const double together = static_cast<double>(grow(one)[0].node_count());
  const auto pair = grow(two);
  const auto apart = static_cast<double>(pair[0].node_count() + pair[1].node_count());
  EXPECT_NEAR(together / apart, 1, 0.25);
}

/// Adds a colonizing tree with small steps that responds to shade: 12 m high, with its crown around x = 3 m.
void add_colonizer(Stand& stand, const Scene& scene) {
  Progress progress;
  const auto points = sample_crown(EllipsoidCrown({3, 8, 0}, Vec3(4)), 600, RandomKey(3), progress);
  ColonizeParameters parameters{
      .step = 0.5, .influence = 3, .kill = 1, .finish = {.decimate = 0, .relax = false, .subdivide = 0}};
  parameters.light.shade.emplace(ShadeResponse{.bears = 0.6, .form = {.voxel = 1, .amount = 0.1, .depth = 6}});
  stand.add(make_colonizer(stand, {{Vec3(3, 0, 0), points}}, parameters, RandomKey(1), scene, SizeLimits(), "bush",
                           Progress()));
}

struct Mixed {
  Skeleton organized;
  Skeleton colonized;
};

Mixed grow_mixed(bool organizer_first, int every) {
  const Scene scene;
  OrganizeParameters parameters = full(16);
  parameters.every = every;
  Stand stand;
  if (organizer_first) add_organizer(stand, parameters, 1, scene);
  add_colonizer(stand, scene);
  if (!organizer_first) add_organizer(stand, parameters, 1, scene);
  auto trees = grow(stand);
  return {std::move(trees[organizer_first ? 0 : 1]), std::move(trees[organizer_first ? 1 : 0])};
}

TEST(OrganizeInAStand, ColonizingAndOrganizingTreesShadeEachOther) {
  // The tree that grows first shades the other.
  const Scene scene;
  Stand alone;
  add_colonizer(alone, scene);
  EXPECT_LT(grow_mixed(true, 1).colonized.node_count(), grow(alone)[0].node_count());
  EXPECT_LT(metamer_count(grow_mixed(true, 6).organized), 0.9 * metamer_count(grow_organized(full(16))));
}

TEST(OrganizeInAStand, ColonizingAndOrganizingTreesMayStandInAnyOrder) {
  for (const int every : {1, 3}) {
    const Mixed one = grow_mixed(true, every);
    const Mixed other = grow_mixed(false, every);
    EXPECT_EQ(skeleton_hash(one.organized), skeleton_hash(other.organized));
    EXPECT_EQ(skeleton_hash(one.colonized), skeleton_hash(other.colonized));
  }
}

TEST(OrganizeInAStand, AloneItDoesNotMatterHowManyRoundsAnIterationTakes) {
  OrganizeParameters parameters = full(10);
  const std::string every_round = skeleton_hash(grow_organized(parameters));
  parameters.every = 3;
  EXPECT_EQ(skeleton_hash(grow_organized(parameters)), every_round);
}

TEST(OrganizeInAStand, MembersStepSideBySideWithTheSameBytes) {
  const Scene scene;
  std::vector<std::string> hashes;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    Stand stand;
    add_colonizer(stand, scene);
    OrganizeParameters parameters = full(12);
    parameters.shedding.below = 0.2;
    parameters.sag = BranchSag{.stiffness = 0.5};
    for (std::uint64_t k = 0; k < 9; ++k) add_organizer(stand, parameters, k, scene, at(2.0F * static_cast<float>(k)));
    stand.add(make_organizer(stand, {{at(-2), nullptr}, {at(-4), nullptr}, {at(-6), nullptr}}, full(12), RandomKey(1),
                             scene, {}, "row"));
    add_colonizer(stand, scene);
    std::string& all = hashes.emplace_back();
    for (const Skeleton& tree : grow(stand)) all += skeleton_hash(tree);
  }
  for (const std::string& hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

}  // namespace meristem::organize_stand_test
