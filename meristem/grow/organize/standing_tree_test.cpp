// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/standing_tree.h"

#include <memory>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/random_metamers.h"

namespace meristem::standing_tree_test {

constexpr std::uint64_t kMuch = 1'000'000'000;
constexpr Vec3 kRoot{3, 0.25F, -7};
constexpr PipeModel kPipes{.tip_radius = 0.005, .exponent = 2, .memory = 1};
constexpr BranchSag kSoft{.stiffness = 0.5, .density = 900, .leaf_mass = 0.01};

/// A wall that shades some positions, and a lamp.
Scene walled() {
  Scene scene;
  scene.obstacles = Obstacles({Obstacle{.mesh = box_mesh({4, 0, -9}, {4.5, 3, -5})}});
  scene.light.sun = {{glm::normalize(Vec3(1, 1, 0)), 1}};
  scene.light.lamps = {{{0, 3, -7}, 2}};
  return scene;
}

/// Returns a random nearby position for each metamer; the seed stays at the root.
TreePose random_pose(RandomKey key, const Metamers& of) {
  TreePose pose;
  pose.tip.resize(of.count(), Vec3(0));
  pose.side.resize(of.count(), Vec3(1, 0, 0));
  for (MetamerIndex metamer = 1; metamer < of.count(); ++metamer) {
    pose.tip[metamer] = pose.tip[of.parent[metamer]] + 0.3F * key.direction(metamer);
    pose.side[metamer] = key.child("side").direction(metamer);
    pose.moment.push_back(Vec3(static_cast<float>(key.child("moment").uniform(metamer, -1, 1)), 0, 0.5F));
  }
  pose.moment.insert(pose.moment.begin(), Vec3(0));
  return pose;
}

/// Never searches for space.
class NoSeeker : public RoomSeeker {
 public:
  bool begin_round() override { return false; }
  void list_seekers(std::vector<SpaceSeeker>&) const override {}
  void take_room(std::span<const BudRoom>) override {}
};

/// A tree in its own space.
struct Grown {
  StandSpace space;
  NoSeeker seeker;
  const ShadowGrid* grid;
  MarkerField* field;
  std::uint32_t volume;
  std::unique_ptr<StandingTree> tree;

  /// Makes a tree with the topology of `like` and the positions of `pose`.
  Grown(const Scene& scene, const Metamers& like, const TreePose& pose, RandomKey key) {
    grid = &space.shade({.voxel = 0.3, .depth = 4}, kMuch, "shade");
    field = &space.markers({.spacing = 0.2, .occupancy = 0.5}, RandomKey(1), scene.obstacles, seeker, kMuch, "markers");
    volume = field->add_volume(nullptr, kRoot);
    tree = std::make_unique<StandingTree>(StandingTree::Place{scene, scene.directions(), kRoot}, space,
                                          Metamers(kUp, Vec3(1, 0, 0), key), kSoft, kPipes);
    for (MetamerIndex metamer = 1; metamer < like.count(); ++metamer) {
      tree->grow(like.parent[metamer], like.begins_shoot(metamer), like.birth[metamer], pose.tip[metamer],
                 pose.side[metamer]);
    }
  }
  void next_round() {
    Progress progress;
    tree->tell();
    space.begin_round(progress);
  }
};

/// Checks that two trees and their effects on others are bitwise equal. The grid may keep memory at positions of
/// removed shoots.
void expect_the_same(Grown& one, Grown& other, RandomKey key, bool in_memory = true) {
  one.next_round();
  other.next_round();
  const Metamers& metamers = one.tree->metamers();
  RC_ASSERT(metamers.count() == other.tree->metamers().count());
  RC_ASSERT(metamers.tip == other.tree->metamers().tip);
  RC_ASSERT(metamers.side == other.tree->metamers().side);
  RC_ASSERT(!in_memory || one.grid->bytes() == other.grid->bytes());
  for (MetamerIndex metamer = 0; metamer < metamers.count(); ++metamer) {
    RC_ASSERT(one.tree->scene_light().at(metamer) == other.tree->scene_light().at(metamer));
  }
  for (std::uint64_t k = 0; k < 300; ++k) {
    const Vec3 position = kRoot + 3 * static_cast<float>(key.uniform(k)) * key.child("way").direction(k);
    RC_ASSERT(one.grid->shade(position) == other.grid->shade(position));
    RC_ASSERT(one.grid->brighter_way(position) == other.grid->brighter_way(position));
  }
  Box around;
  around.add(kRoot - 1.5F);
  around.add(kRoot + 1.5F);
  RC_ASSERT(one.field->free_markers(around, one.volume) == other.field->free_markers(around, other.volume));
}

RC_GTEST_PROP(StandingTree, AfterAMoveAllIsAsIfItHadGrownThere, ()) {
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  const Scene scene = walled();
  const Metamers form = random_metamers(key, 40);
  const TreePose there = random_pose(key.child("there"), form);
  TreePose half = random_pose(key.child("half"), form);
  // First move only the later metamers, then all.
  for (MetamerIndex metamer = 0; metamer < 20; ++metamer) half.tip[metamer] = there.tip[metamer];
  Grown moved(scene, form, random_pose(key.child("here"), form), key);
  if (key.uniform(0) < 0.5) moved.next_round();
  moved.tree->move(half);
  if (key.uniform(1) < 0.5) moved.next_round();
  moved.tree->move(there);
  Grown built(scene, form, there, key);
  expect_the_same(moved, built, key);
}

RC_GTEST_PROP(StandingTree, WhatIsRemovedAfterAMoveLeavesNothing, ()) {
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  const Scene scene = walled();
  const Metamers form = random_metamers(key, 40);
  const TreePose there = random_pose(key.child("there"), form);
  Grown moved(scene, form, random_pose(key.child("here"), form), key);
  moved.tree->move(there);
  Grown built(scene, form, there, key);
  const auto first = static_cast<MetamerIndex>(key.uniform(0, 1, static_cast<double>(form.count())));
  for (StandingTree* tree : {moved.tree.get(), built.tree.get()}) {
    tree->cut_off(first, Bud::damaged());
    EXPECT_FALSE(tree->clear_away().empty());
  }
  expect_the_same(moved, built, key);
}

RC_GTEST_PROP(StandingTree, WhatIsCutIsAsIfItHadNeverGrown, ()) {
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  const Scene scene = walled();
  const Metamers form = random_metamers(key, 40);
  const TreePose pose = random_pose(key.child("pose"), form);
  const auto first = static_cast<MetamerIndex>(key.uniform(0, 1, static_cast<double>(form.count())));
  Metamers left = form;
  left.cut_off(first, Bud::damaged());
  const std::vector<std::uint8_t> gone = left.clear_away();
  TreePose pose_left = pose;
  erase_marked(pose_left.tip, gone);
  erase_marked(pose_left.side, gone);
  Grown cut(scene, form, pose, key);
  if (key.uniform(1) < 0.5) cut.next_round();
  cut.tree->cut_off(first, Bud::damaged());
  cut.tree->clear_away();
  Grown built(scene, left, pose_left, key);
  expect_the_same(cut, built, key, false);
}

RC_GTEST_PROP(StandingTree, BendsFurtherFromTheMomentsThatItWasMovedWith, ()) {
  // Two trees with equal positions and moments must continue to bend equally.
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  const Scene scene = walled();
  const Metamers form = random_metamers(key, 30);
  TreePose there = random_pose(key.child("there"), form);
  for (Vec3& tip : there.tip) tip.y = std::abs(tip.y);
  Grown one(scene, form, random_pose(key.child("here"), form), key);
  Grown other(scene, form, there, key);
  one.tree->sag(3);
  one.tree->move(there);
  other.tree->move(there);
  expect_the_same(one, other, key);
  one.tree->sag(1000);
  other.tree->sag(1000);
  RC_ASSERT(one.tree->metamers().tip != there.tip);
  expect_the_same(one, other, key);
}

TEST(StandingTree, WhatDoesNotMoveIsNotTold) {
  const Scene scene = walled();
  const Metamers form = random_metamers(RandomKey(4), 30);
  const TreePose pose = random_pose(RandomKey(5), form);
  Grown one(scene, form, pose, RandomKey(6));
  one.next_round();
  const std::size_t before = one.grid->bytes();
  one.tree->move(pose);
  one.next_round();
  EXPECT_EQ(one.grid->bytes(), before);
  EXPECT_EQ(one.tree->metamers().tip, pose.tip);
}

}  // namespace meristem::standing_tree_test
