// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/marker/marker_field.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <tuple>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/scene/crown/profile_crown.h"

namespace meristem::marker_field_test {

constexpr float kSpacing = 0.07F;
const MarkerParameters kForm{.spacing = kSpacing, .occupancy = 0.2};

/// A ball, 1 m above the root.
class Ball : public Crown {
 public:
  explicit Ball(float radius) : radius_(radius) {}
  bool contains(Vec3 point) const override { return squared_length(point - kUp) <= radius_ * radius_; }
  Box bounds() const override { return {kUp - radius_, kUp + radius_}; }

 private:
  float radius_;
};

CrownPointer ball(float radius) { return std::make_shared<Ball>(radius); }

Obstacles wall() { return Obstacles(std::vector<Obstacle>{{.mesh = box_mesh({0.3, 0, -2}, {0.5, 2, 2})}}); }

/// `count` points in a ball around `middle`.
std::vector<Vec3> crowd(int count, Vec3 middle, float radius, std::uint64_t seed = 1) {
  const RandomKey key = RandomKey(seed).child("crowd");
  const RandomKey ways = key.child("ways");
  std::vector<Vec3> places;
  for (std::uint64_t k = 0; k < static_cast<std::uint64_t>(count); ++k) {
    places.push_back(middle + radius * static_cast<float>(std::cbrt(key.uniform(k))) * ways.direction(k));
  }
  return places;
}

/// Two buds at each position, as at the end of a metamer, with the volumes in turn.
std::vector<SpaceSeeker> buds_at(const std::vector<Vec3>& places, std::uint32_t volumes, std::uint64_t seed = 1) {
  const RandomKey key = RandomKey(seed).child("buds");
  std::vector<SpaceSeeker> seekers;
  for (const Vec3 position : places) {
    const auto volume = static_cast<std::uint32_t>(seekers.size() / 2 % volumes);
    for (int k = 0; k < 2; ++k) seekers.push_back({position, key.direction(seekers.size()), volume, 0.4F, 0.70710678F});
  }
  return seekers;
}

std::vector<BudRoom> share_out(MarkerField& field, const std::vector<SpaceSeeker>& seekers) {
  std::vector<BudRoom> rooms(seekers.size());
  field.share_out(seekers, rooms, Progress());
  return rooms;
}

void expect_same(const std::vector<BudRoom>& a, const std::vector<BudRoom>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].count, b[k].count) << k;
    ASSERT_EQ(a[k].way, b[k].way) << k;
  }
}

std::uint32_t total(const std::vector<BudRoom>& rooms) {
  std::uint32_t sum = 0;
  for (const BudRoom& room : rooms) sum += room.count;
  return sum;
}

/// The reference implementation: tests every marker of a box against every shoot and every bud.
class PlainField {
 public:
  /// Copies the markers of a field without shoots.
  PlainField(const MarkerField& fresh, const Box& box, std::uint32_t volumes) : spacing_(fresh.form().spacing) {
    reach_ = static_cast<float>(fresh.form().occupancy / spacing_);
    std::map<std::tuple<double, double, double>, std::uint32_t> markers;
    for (std::uint32_t volume = 0; volume < volumes; ++volume) {
      for (const DVec3 at : fresh.free_markers(box, volume)) markers[{at.x, at.y, at.z}] |= 1U << volume;
    }
    for (const auto& [at, within] : markers) {
      const auto [x, y, z] = at;
      markers_.push_back({DVec3(x, y, z) / spacing_, within});
    }
  }

  void occupy(Vec3 position) {
    const DVec3 shoot = fine(position);
    for (Marker& marker : markers_) {
      if (squared_length(way(shoot, marker)) <= reach_ * reach_) marker.is_free = false;
    }
  }

  std::vector<BudRoom> share_out(const std::vector<SpaceSeeker>& seekers) const {
    struct Claim {
      float square = std::numeric_limits<float>::infinity();
      std::size_t seeker = 0;
    };
    std::vector<Claim> claims(markers_.size());
    for (std::size_t k = 0; k < seekers.size(); ++k) {
      const DVec3 bud = fine(seekers[k].position);
      const float radius = seekers[k].radius / static_cast<float>(spacing_);
      const float slope = seekers[k].cosine * std::abs(seekers[k].cosine);
      for (std::size_t i = 0; i < markers_.size(); ++i) {
        if (!markers_[i].is_free || (markers_[i].volumes >> seekers[k].volume & 1) == 0) continue;
        const Vec3 to = way(bud, markers_[i]);
        const float square = squared_length(to);
        if (square > radius * radius || square >= claims[i].square) continue;
        const float along = glm::dot(seekers[k].direction, to);
        if (along * std::abs(along) >= slope * square) claims[i] = {square, k};
      }
    }
    std::vector<DVec3> sums(seekers.size(), DVec3(0));
    std::vector<BudRoom> rooms(seekers.size());
    for (std::size_t i = 0; i < markers_.size(); ++i) {
      const auto [square, k] = claims[i];
      if (square == std::numeric_limits<float>::infinity()) continue;
      ++rooms[k].count;
      sums[k] += glm::normalize(DVec3(way(fine(seekers[k].position), markers_[i])));
      rooms[k].way = Vec3(sums[k]);
    }
    return rooms;
  }

 private:
  struct Marker {
    DVec3 position{0};  // voxels
    std::uint32_t volumes = 0;
    bool is_free = true;
  };

  DVec3 fine(Vec3 position) const { return glm::floor(DVec3(position) * (65536 / spacing_) + 0.5) / 65536.0; }
  static Vec3 way(DVec3 from, const Marker& marker) {
    return Vec3(glm::round((marker.position - from) * 65536.0) / 65536.0);
  }

  double spacing_;
  float reach_ = 0;
  std::vector<Marker> markers_;
};

/// Counts must be equal; directions may differ by rounding.
void expect_like_plain(const std::vector<BudRoom>& rooms, const std::vector<BudRoom>& plain) {
  ASSERT_EQ(rooms.size(), plain.size());
  for (std::size_t k = 0; k < rooms.size(); ++k) {
    ASSERT_EQ(rooms[k].count, plain[k].count) << "bud " << k;
    ASSERT_LT(glm::distance(rooms[k].way, plain[k].way), 1e-5F * static_cast<float>(1 + plain[k].count)) << "bud " << k;
  }
}

TEST(MarkerField, ThereIsOneMarkerInEachVoxel) {
  MarkerField field({.spacing = 0.25}, RandomKey(1));
  field.add_volume(nullptr, Vec3(0));
  const std::vector<DVec3> markers = field.free_markers({Vec3(-2), Vec3(3)}, 0);
  ASSERT_EQ(markers.size(), 20U * 20 * 20);
  std::map<std::tuple<int, int, int>, int> in_voxel;
  DVec3 sum(0);
  for (const DVec3 marker : markers) {
    const DVec3 voxel = glm::floor(marker / 0.25);
    ++in_voxel[{static_cast<int>(voxel.x), static_cast<int>(voxel.y), static_cast<int>(voxel.z)}];
    sum += marker / 0.25 - voxel;
  }
  EXPECT_EQ(in_voxel.size(), markers.size());
  // The mean of 8000 positions uniform in a voxel is within 5 standard deviations of the centre: 5 / sqrt(12 * 8000) =
  // 0.016.
  const DVec3 mean = sum / static_cast<double>(markers.size());
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(mean[k], 0.5, 0.016);
}

TEST(MarkerField, AnotherKeyPutsMarkersElsewhere) {
  const auto first = [](std::uint64_t seed) {
    MarkerField field(kForm, RandomKey(seed));
    field.add_volume(nullptr, Vec3(0));
    return field.free_markers({Vec3(0), Vec3(1)}, 0).front();
  };
  EXPECT_EQ(first(1), first(1));
  EXPECT_NE(first(1), first(2));
}

TEST(MarkerField, ABudFindsTheShareOfABallThatItsConeCuts) {
  MarkerField field({.spacing = 0.02, .occupancy = 0}, RandomKey(4));
  field.add_volume(nullptr, Vec3(0));
  for (const float cosine : {0.9F, 0.5F, 0.0F, -0.5F, -1.0F}) {
    const BudRoom room = share_out(field, {{{0.3F, 0.2F, 0.1F}, {0, 0.6F, 0.8F}, 0, 0.4F, cosine}}).front();
    // The cone has the solid angle 2 pi (1 - c), and the mean component of a unit vector along its axis is (1 + c) / 2.
    const double expected = 2 * kPi / 3 * (1 - cosine) * 0.4 * 0.4 * 0.4 / (0.02 * 0.02 * 0.02);
    EXPECT_NEAR(room.count, expected, 0.02 * expected) << cosine;
    const Vec3 mean = room.way / static_cast<float>(room.count);
    EXPECT_LT(glm::distance(mean, (1 + cosine) / 2 * Vec3(0, 0.6F, 0.8F)), 0.02F) << cosine;
  }
}

TEST(MarkerField, AShootTakesTheBallAroundIt) {
  MarkerField field({.spacing = 0.02, .occupancy = 0.2}, RandomKey(4));
  field.add_volume(nullptr, Vec3(0));
  const SpaceSeeker all_around{Vec3(0.5F), kUp, 0, 0.4F, -1};
  const std::uint32_t before = share_out(field, {all_around}).front().count;
  field.occupy(all_around.position);
  const std::uint32_t after = share_out(field, {all_around}).front().count;
  EXPECT_NEAR(after, before * 7 / 8.0, 0.01 * before);
}

TEST(MarkerField, IsTheSameAsEveryMarkerAgainstEveryBud) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    // Two overlapping crowns and all of space; half of the seeds have a wall.
    MarkerField field(kForm, RandomKey(seed), seed % 2 == 0 ? Obstacles{} : wall());
    field.add_volume(ball(0.6F), {-0.3F, 0, 0});
    field.add_volume(ball(0.5F), {0.3F, 0.1F, 0});
    const std::uint32_t volumes = seed < 3 ? 2 : field.add_volume(nullptr, Vec3(0)) + 1;
    const Vec3 middle(0, 1, 0);
    PlainField plain(field, {middle - 1.2F, middle + 1.2F}, volumes);
    for (int round = 0; round < 2; ++round) {
      for (const Vec3 position : crowd(15, middle, 0.6F, 10 * seed + round)) {
        field.occupy(position);
        plain.occupy(position);
      }
      std::vector<SpaceSeeker> seekers = buds_at(crowd(60, middle, 0.8F, 10 * seed + round + 5), volumes, seed);
      for (std::size_t k = 0; k < seekers.size(); k += 7) seekers[k].radius = 0.1F * static_cast<float>(k % 5);
      for (std::size_t k = 0; k < seekers.size(); k += 5) seekers[k].cosine = -1 + 0.2F * static_cast<float>(k % 11);
      for (std::size_t k = 0; k < seekers.size(); k += 13) seekers[k].radius = seekers[k].volume < 2 ? 1.2F : 0.4F;
      const std::vector<BudRoom> rooms = share_out(field, seekers);
      EXPECT_GT(total(rooms), 300U);
      expect_like_plain(rooms, plain.share_out(seekers));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(MarkerField, IsTheSameFarFromTheOrigin) {
  const Vec3 far(-90000, 250, 120000);  // floats have a resolution of a centimetre there
  MarkerField field({.spacing = 0.1, .occupancy = 0.3}, RandomKey(2));
  field.add_volume(ball(1), far);
  PlainField plain(field, {far - 1.5F, far + 2.5F}, 1);
  for (const Vec3 position : crowd(60, far + kUp, 0.7F)) {
    field.occupy(position);
    plain.occupy(position);
  }
  const std::vector<SpaceSeeker> seekers = buds_at(crowd(100, far + kUp, 1), 1);
  const std::vector<BudRoom> rooms = share_out(field, seekers);
  EXPECT_GT(total(rooms), 500U);
  expect_like_plain(rooms, plain.share_out(seekers));
}

TEST(MarkerField, IsTheSameAtTheLongestReach) {
  MarkerField field({.spacing = 0.0625, .occupancy = 2}, RandomKey(2));
  field.add_volume(ball(1.7F), Vec3(0));
  PlainField plain(field, {kUp - 1.75F, kUp + 1.75F}, 1);
  field.occupy({1.5F, 0, 0});
  plain.occupy({1.5F, 0, 0});
  std::vector<SpaceSeeker> seekers = buds_at(crowd(8, {-0.5F, 1, 0}, 1), 1);
  for (std::size_t k = 0; k < seekers.size(); ++k) {
    seekers[k].radius = 2;
    seekers[k].cosine = 1 - static_cast<float>(k * k) / 128;
  }
  const std::vector<BudRoom> rooms = share_out(field, seekers);
  EXPECT_GT(total(rooms), 10'000U);
  expect_like_plain(rooms, plain.share_out(seekers));
}

TEST(MarkerField, EachMarkerGoesToOneBud) {
  MarkerField field(kForm, RandomKey(2));
  field.add_volume(nullptr, Vec3(0));
  const SpaceSeeker bud{Vec3(0.2F), kUp, 0, 0.4F, -1};
  const std::vector<BudRoom> alone = share_out(field, {bud});
  ASSERT_GT(alone[0].count, 100U);
  // The first of two seekers at one position gets all markers.
  const std::vector<BudRoom> twins = share_out(field, {bud, bud});
  expect_same({twins[0]}, alone);
  EXPECT_EQ(twins[1].count, 0U);
  EXPECT_EQ(twins[1].way, Vec3(0));
  // Neighbouring buds divide their markers at the plane between them.
  SpaceSeeker other = bud;
  other.position.x += 0.1F;
  const std::vector<BudRoom> pair = share_out(field, {bud, other});
  EXPECT_LT(pair[0].way.x, -0.2F * static_cast<float>(pair[0].count));
  EXPECT_GT(pair[1].way.x, 0.2F * static_cast<float>(pair[1].count));
  // Together, the buds get every marker that one of them sees.
  std::vector<SpaceSeeker> crowded(50, bud);
  for (std::size_t k = 0; k < crowded.size(); ++k) crowded[k].direction = RandomKey(7).direction(k);
  EXPECT_EQ(total(share_out(field, crowded)), alone[0].count);
}

TEST(MarkerField, WhoYieldsGetsWhatNobodyElseSees) {
  MarkerField field(kForm, RandomKey(2));
  field.add_volume(nullptr, Vec3(0));
  const std::vector<SpaceSeeker> living = buds_at(crowd(12, kUp, 0.5F), 1);
  std::vector<SpaceSeeker> all =
      buds_at(crowd(8, kUp, 0.7F, 5), 1, 5);  // nearer to some markers, and first in the list
  const std::size_t yielding = all.size();
  all.insert(all.end(), living.begin(), living.end());
  const std::uint32_t seen = total(share_out(field, all));
  for (std::size_t k = 0; k < yielding; ++k) all[k].yields = true;
  const std::vector<BudRoom> rooms = share_out(field, all);
  const std::vector<BudRoom> left(rooms.begin(), rooms.begin() + static_cast<std::ptrdiff_t>(yielding));
  // The other seekers get the same markers as without the yielding ones, and every marker that is seen is assigned.
  expect_same({rooms.begin() + static_cast<std::ptrdiff_t>(yielding), rooms.end()}, share_out(field, living));
  EXPECT_GT(total(left), 100U);
  EXPECT_EQ(total(rooms), seen);
  // A yielding seeker gets no marker that a bud at the same position sees, in any order of the list.
  SpaceSeeker stump{Vec3(0.2F), kUp, 0, 0.4F, -1, true};
  SpaceSeeker bud = stump;
  bud.yields = false;
  EXPECT_EQ(share_out(field, {stump, bud})[0].count, 0U);
  EXPECT_EQ(share_out(field, {stump})[0].count, share_out(field, {bud})[0].count);
}

TEST(MarkerField, NoBudSeesMarkersInObstaclesOrOutsideItsVolume) {
  MarkerField field(kForm, RandomKey(2), wall());
  const std::uint32_t volume = field.add_volume(ball(0.6F), {0.2F, 0, 0});
  const Obstacles obstacles = wall();
  const std::vector<DVec3> markers = field.free_markers({Vec3(-3), Vec3(3)}, volume);
  EXPECT_GT(markers.size(), 1000U);
  for (const DVec3 marker : markers) {
    EXPECT_LE(glm::distance(marker, DVec3(0.2, 1, 0)), 0.6 + 1e-6);
    EXPECT_FALSE(obstacles.contain(Vec3(marker)));
  }
  // Buds everywhere take all markers, each once.
  std::vector<SpaceSeeker> seekers;
  for (int k = 0; k < 1000; ++k) {
    const Vec3 step(static_cast<float>(k % 10), static_cast<float>(k / 10 % 10), static_cast<float>(k / 100));
    seekers.push_back({Vec3(-0.7F, 0.1F, -0.9F) + 0.2F * step, kUp, volume, 0.4F, -1});
  }
  EXPECT_EQ(total(share_out(field, seekers)), markers.size());
}

TEST(MarkerField, VacatingIsTheExactInverse) {
  MarkerField field(kForm, RandomKey(3), wall());
  const std::uint32_t volumes = 1 + field.add_volume(ball(1), Vec3(0));
  for (const Vec3 position : crowd(60, kUp, 1, 1)) field.occupy(position);
  const std::vector<SpaceSeeker> seekers = buds_at(crowd(300, kUp, 1, 2), volumes);
  const std::vector<BudRoom> before = share_out(field, seekers);
  const std::vector<Vec3> leave = crowd(800, kUp, 1, 3);
  for (const Vec3 position : leave) field.occupy(position);
  EXPECT_LT(total(share_out(field, seekers)), total(before) / 2);
  for (const Vec3 position : leave) field.vacate(position);
  expect_same(share_out(field, seekers), before);
}

TEST(MarkerField, CountsMoreShootsThanAByteHolds) {
  MarkerField field(kForm, RandomKey(3));
  field.add_volume(nullptr, Vec3(0));
  const std::vector<SpaceSeeker> seekers = buds_at(crowd(20, Vec3(0), 0.3F), 1);
  const std::vector<BudRoom> before = share_out(field, seekers);
  const auto repeat = [](int times, const std::function<void()>& what) {
    for (int k = 0; k < times; ++k) what();
  };
  repeat(1, [&] { field.occupy(Vec3(0)); });
  const std::vector<BudRoom> taken = share_out(field, seekers);
  EXPECT_NE(total(taken), total(before));
  for (const int times : {254, 1, 1, 300, 512}) {
    repeat(times, [&] { field.occupy(Vec3(0)); });
    expect_same(share_out(field, seekers), taken);
    field.occupy(Vec3(1.1F));
  }
  for (const int times : {512, 300, 1, 1, 254}) {
    repeat(times, [&] { field.vacate(Vec3(0)); });
    expect_same(share_out(field, seekers), taken);
    field.vacate(Vec3(1.1F));
  }
  field.vacate(Vec3(0));
  expect_same(share_out(field, seekers), before);
  EXPECT_THROW(field.vacate(Vec3(0)), std::invalid_argument);
}

RC_GTEST_PROP(MarkerField, DoesNotKnowTheOrderOfShoots, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
  const auto count = *rc::gen::inRange(0, 100);
  const std::vector<Vec3> places = crowd(count, Vec3(0), 0.8F, seed);
  const std::vector<Vec3> gone = crowd(20, Vec3(0), 0.8F, seed + 1);
  const std::vector<SpaceSeeker> seekers = buds_at(places, 1);
  MarkerField forward(kForm, RandomKey(1));
  MarkerField backward(kForm, RandomKey(1));
  forward.add_volume(nullptr, Vec3(0));
  backward.add_volume(nullptr, Vec3(0));
  for (const Vec3 position : places) forward.occupy(position);
  for (const Vec3 position : gone) backward.occupy(position);
  for (auto position = places.rbegin(); position != places.rend(); ++position) backward.occupy(*position);
  for (const Vec3 position : gone) backward.vacate(position);
  expect_same(share_out(forward, seekers), share_out(backward, seekers));
}

TEST(MarkerField, ARoundDoesNotChangeTheNext) {
  MarkerField field(kForm, RandomKey(3), wall());
  field.add_volume(ball(1), Vec3(0));
  field.add_volume(ball(1), {0.4F, 0, 0});
  for (const Vec3 position : crowd(60, kUp, 1)) field.occupy(position);
  const std::vector<SpaceSeeker> seekers = buds_at(crowd(300, kUp, 1), 2);
  const std::vector<BudRoom> first = share_out(field, seekers);
  const std::size_t bytes = field.bytes();
  share_out(field, buds_at(crowd(50, Vec3(3), 1), 1));
  expect_same(share_out(field, seekers), first);
  EXPECT_GT(field.bytes(), bytes);
  // An additional volume does not change the results of the existing ones.
  field.add_volume(nullptr, Vec3(0));
  expect_same(share_out(field, seekers), first);
}

TEST(MarkerField, IsTheSameOnAnyNumberOfThreads) {
  std::vector<BudRoom> first;
  std::size_t bytes = 0;
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    MarkerField field(kForm, RandomKey(3), wall());
    field.add_volume(ball(2), Vec3(0));
    field.add_volume(ball(2), {0.5F, 0, 0});
    for (const Vec3 position : crowd(2000, kUp, 2, 8)) field.occupy(position);
    const std::vector<BudRoom> rooms = share_out(field, buds_at(crowd(5000, kUp, 2, 9), 2));
    if (threads == 1) {
      first = rooms;
      bytes = field.bytes();
      EXPECT_GT(total(rooms), 10'000U);
    }
    expect_same(rooms, first);
    EXPECT_EQ(field.bytes(), bytes);
  }
}

TEST(MarkerField, TakesMemoryForShootsAndBudsAlone) {
  const auto bytes_in = [](float size) {
    MarkerField field(kForm, RandomKey(3));
    field.add_volume(std::make_shared<ProfileCrown>(ProfileCrown::Profile{{size, -size}, {size, size}}), Vec3(0));
    for (const Vec3 position : crowd(100, Vec3(0), 1)) field.occupy(position);
    const std::vector<BudRoom> rooms = share_out(field, buds_at(crowd(100, Vec3(0), 1), 1));
    return std::pair(total(rooms), field.bytes());
  };
  EXPECT_EQ(bytes_in(3), bytes_in(500)) << "metres each way";
}

TEST(MarkerField, StopsWhenAsked) {
  MarkerField field(kForm, RandomKey(3));
  field.add_volume(ball(1), Vec3(0));
  const std::vector<SpaceSeeker> seekers = buds_at(crowd(100, kUp, 1), 1);
  std::vector<BudRoom> rooms(seekers.size(), {.count = 7});
  Progress progress;
  progress.cancel();
  EXPECT_THROW(field.share_out(seekers, rooms, progress), Cancelled);
  EXPECT_EQ(rooms[0].count, 7U);
  MarkerField fresh(kForm, RandomKey(3));
  fresh.add_volume(ball(1), Vec3(0));
  expect_same(share_out(field, seekers), share_out(fresh, seekers));
}

TEST(MarkerField, RefusesWhatIsOutOfRange) {
  const auto makes = [](const MarkerParameters& form) { return MarkerField(form, RandomKey(1)).bytes(); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(makes({.spacing = 0.1, .occupancy = 3.2}));
  EXPECT_THROW(makes({.spacing = 0.1, .occupancy = 3.3}), std::invalid_argument);
  EXPECT_THROW(makes({.spacing = 0.1, .occupancy = -1}), std::invalid_argument);
  EXPECT_THROW(makes({.spacing = 0.1, .occupancy = nan}), std::invalid_argument);
  EXPECT_THROW(makes({.spacing = 0}), std::invalid_argument);
  EXPECT_THROW(makes({.spacing = nan}), std::invalid_argument);

  MarkerField field(kForm, RandomKey(1));
  field.add_volume(nullptr, Vec3(0));
  EXPECT_THROW(field.occupy({0, static_cast<float>(nan), 0}), std::invalid_argument);
  EXPECT_THROW(field.occupy({0, 0, 1e9F}), std::invalid_argument);
  EXPECT_THROW(field.vacate({0, 0, 0}), std::invalid_argument);
  const auto is_refused = [&](const SpaceSeeker& seeker) {
    try {
      share_out(field, {seeker});
      return false;
    } catch (const std::invalid_argument&) {
      return true;
    }
  };
  const auto no_number = static_cast<float>(nan);
  EXPECT_FALSE(is_refused({}));
  EXPECT_FALSE(is_refused({.radius = 2.24F}));
  EXPECT_TRUE(is_refused({.radius = 2.3F}));
  EXPECT_TRUE(is_refused({.radius = no_number}));
  EXPECT_TRUE(is_refused({.position = {no_number, 0, 0}}));
  EXPECT_TRUE(is_refused({.direction = {0, 0, 0}}));
  EXPECT_TRUE(is_refused({.direction = {0, 0, 1.001F}}));
  EXPECT_TRUE(is_refused({.direction = {0, no_number, 0}}));
  EXPECT_TRUE(is_refused({.cosine = 1.1F}));
  EXPECT_TRUE(is_refused({.volume = 1}));
  std::vector<BudRoom> rooms(2);
  EXPECT_THROW(field.share_out(std::vector<SpaceSeeker>(1), rooms, Progress()), std::invalid_argument);
}

}  // namespace meristem::marker_field_test
