// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/stand_space.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/random.h"

namespace meristem::stand_space_test {

constexpr std::uint64_t kMuch = 1'000'000'000;

Vec3 place_of(RandomKey key, std::uint64_t k) {
  return {static_cast<float>(key.uniform(3 * k, -9, 9)), static_cast<float>(key.uniform(3 * k + 1, -9, 9)),
          static_cast<float>(key.uniform(3 * k + 2, -9, 9))};
}

void next_round(StandSpace& space) {
  Progress progress;
  space.begin_round(progress);
}

TEST(StandSpace, IsFeltWhereAPlantAsksForIt) {
  StandSpace space;
  EXPECT_FALSE(space.is_felt());
  space.shade({.voxel = 1}, kMuch, "a");
  EXPECT_TRUE(space.is_felt());
}

TEST(StandSpace, EqualFormsShareAGrid) {
  StandSpace space;
  const ShadowGrid& one = space.shade({.voxel = 1}, kMuch, "a");
  const ShadowGrid& other = space.shade({.voxel = 2}, kMuch, "b");
  EXPECT_EQ(&space.shade({.voxel = 1}, kMuch, "c"), &one);
  EXPECT_NE(&other, &one);
}

TEST(StandSpace, WhatGrowsIsFeltFromTheNextRoundOn) {
  StandSpace space;
  const ShadowGrid& grid = space.shade({.voxel = 1}, kMuch, "a");
  space.grow_shoot({0.5F, 0.5F, 0.5F}, 1);
  EXPECT_TRUE(grid.empty());
  next_round(space);
  EXPECT_NEAR(grid.shade({0.5F, 0.5F, 0.5F}), 0.2, 1e-9);
  next_round(space);
  EXPECT_NEAR(grid.shade({0.5F, 0.5F, 0.5F}), 0.2, 1e-9);
}

TEST(StandSpace, ShootsCastShadeByTheirLengthInVoxels) {
  StandSpace space;
  const ShadowGrid& fine = space.shade({.voxel = 0.5}, kMuch, "a");
  const ShadowGrid& coarse = space.shade({.voxel = 2}, kMuch, "b");
  space.grow_shoot({0.1F, 0.1F, 0.1F}, 1);
  next_round(space);
  EXPECT_NEAR(fine.shade({0.1F, 0.1F, 0.1F}), 0.4, 1e-9);
  EXPECT_NEAR(coarse.shade({0.1F, 0.1F, 0.1F}), 0.1, 1e-9);
}

RC_GTEST_PROP(StandSpace, WhatIsLostIsAsIfItHadNeverBeen, ()) {
  // Shoots grow in several rounds. Some of them are lost, in any order; the others stay.
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  StandSpace space;
  const ShadowParameters form{.voxel = 1, .amount = 0.3, .base = 1.7, .depth = 5};
  const ShadowGrid& grid = space.shade(form, kMuch, "a");
  ShadowGrid wanted(form);
  const auto length = [&](std::uint64_t k) { return key.child("length").uniform(k, 0.01, 3); };
  for (std::uint64_t k = 0; k < 60; ++k) {
    space.grow_shoot(place_of(key, k), length(k));
    if (k % 3 == 0) wanted.add(place_of(key, k), length(k));
    if (k % 10 == 0) next_round(space);
  }
  for (std::uint64_t k = 60; k-- > 0;) {
    if (k % 3 != 0) space.lose_shoot(place_of(key, k), length(k));
  }
  next_round(space);
  for (std::uint64_t k = 0; k < 3000; ++k) {
    const Vec3 position = 1.7F * place_of(key.child("asked"), k);
    RC_ASSERT(grid.shade(position) == wanted.shade(position));
  }
  for (std::uint64_t k = 0; k < 60; k += 3) space.lose_shoot(place_of(key, k), length(k));
  next_round(space);
  RC_ASSERT(grid.empty());
}

TEST(StandSpace, ItsBytesAreLimitedAtTheParameterToChange) {
  StandSpace space;
  space.shade({.voxel = 1}, 100'000, "components.tree.light.voxel");
  try {
    for (std::uint64_t k = 0; k < 1000; ++k) space.grow_shoot(100.0F * place_of(RandomKey(1), k), 1);
    next_round(space);
    FAIL() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].path, "components.tree.light.voxel");
    EXPECT_NE(error.diagnostics()[0].text().find("bytes of shade"), std::string::npos) << error.what();
    EXPECT_NE(error.diagnostics()[0].text().find("mesh_bytes"), std::string::npos) << error.what();
  }
}

TEST(StandSpace, StopsWhenAsked) {
  StandSpace space;
  space.shade({.voxel = 1}, kMuch, "a");
  space.grow_shoot(Vec3(0), 1);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(space.begin_round(progress), Cancelled);
}

TEST(StandSpace, WhatIsTooFarAwayForAFineGridDoesNotMatterToIt) {
  Stand stand;
  auto& space = stand.commons<StandSpace>();
  const ShadowGrid& fine = space.shade({.voxel = 1e-6}, 1'000'000, "fine");
  space.grow_shoot({1e5F, 0, 0}, 1);
  space.grow_shoot({0, 0, 0}, 1e-6);
  Progress progress;
  space.begin_round(progress);
  EXPECT_FALSE(fine.reaches({1e5F, 0, 0}));
  EXPECT_GT(fine.shade(Vec3(0)), 0);
}

/// Searches for space in every other round.
class SecondRoundSeeker : public RoomSeeker {
 public:
  bool begin_round() override { return round_++ % 2 == 0; }
  void list_seekers(std::vector<SpaceSeeker>& seekers) const override { seekers.push_back({.radius = 2}); }
  void take_room(std::span<const BudRoom> rooms) override {
    ++answers_;
    count_ = rooms[0].count;
  }
  int answers() const { return answers_; }
  std::uint32_t count() const { return count_; }

 private:
  int round_ = 0;
  int answers_ = 0;
  std::uint32_t count_ = 0;
};

TEST(StandSpace, RoomIsSharedOutWhereSomebodyLooks) {
  StandSpace space;
  SecondRoundSeeker seeker;
  space.markers({.spacing = 0.5, .occupancy = 1}, RandomKey(1), Obstacles(), seeker, kMuch, "a")
      .add_volume(nullptr, Vec3(0));
  for (int round = 0; round < 5; ++round) next_round(space);
  EXPECT_EQ(seeker.answers(), 3);
  EXPECT_GT(seeker.count(), 0U);
}

TEST(StandSpace, ShootsTakeRoomAndGiveItBackHoweverShortTheyAre) {
  StandSpace space;
  SecondRoundSeeker seeker;
  space.markers({.spacing = 0.5, .occupancy = 1}, RandomKey(1), Obstacles(), seeker, kMuch, "a")
      .add_volume(nullptr, Vec3(0));
  next_round(space);
  const std::uint32_t free = seeker.count();
  const auto look_again = [&] {
    next_round(space);
    next_round(space);
    return seeker.count();
  };
  space.grow_shoot({0, 1, 0}, 0);
  space.grow_shoot({0, 1.5F, 0}, 1);
  EXPECT_LT(look_again(), free);
  space.lose_shoot({0, 1.5F, 0}, 1);
  space.lose_shoot({0, 1, 0}, 0);
  EXPECT_EQ(look_again(), free);
}

TEST(StandSpace, MemoryOfARoundIsLimitedAtTheParameterToChange) {
  StandSpace space;
  SecondRoundSeeker seeker;
  space.markers({.spacing = 0.5, .occupancy = 1}, RandomKey(1), Obstacles(), seeker, 20, "light.spacing")
      .add_volume(nullptr, Vec3(0));
  try {
    next_round(space);
    FAIL() << "it fits";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].path, "light.spacing");
  }
}

TEST(StandSpace, AShootOfManyVoxelsCastsNoEndlessShade) {
  StandSpace space;
  const ShadowGrid& fine = space.shade({.voxel = 1e-3}, kMuch, "a");
  space.grow_shoot(Vec3(0), 1e6);
  next_round(space);
  space.lose_shoot(Vec3(0), 1e6);
  next_round(space);
  EXPECT_TRUE(fine.empty());
}

}  // namespace meristem::stand_space_test
