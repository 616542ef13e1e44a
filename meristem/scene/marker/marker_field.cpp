// SPDX-License-Identifier: Apache-2.0
// Shares out markers among buds: a marker belongs to the nearest bud that sees it. The vector from bud to marker is
// exact in floats, and the sums of a bud are whole numbers. The result therefore depends neither on bricks nor on
// threads.
#include "meristem/scene/marker/marker_field.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/scene/marker/marker_contest.h"

namespace meristem {

namespace {

constexpr std::uint32_t kInBrick = MarkerBricks::kInBrick;
constexpr float kUnitLength = 4294967296;  // fixed-point length of a unit vector
constexpr std::size_t kBrickGrain = 32;
constexpr std::uint64_t kBytesASighting = 16;         // memory of one brick seen by one seeker, in a round
constexpr std::uint64_t kMaxSightings = 0xffffffffU;  // limit of 32-bit counts

}  // namespace

/// The sums of a look. They are whole numbers, so the order of additions on many threads does not matter.
struct MarkerField::Tally {
  std::uint32_t count = 0;
  std::array<std::int64_t, 3> way{};  // in units of 2^-32

  void raise(const Tally& more) {
    const auto add = [](auto& number, auto by) { std::atomic_ref(number).fetch_add(by, std::memory_order_relaxed); };
    add(count, more.count);
    for (int k = 0; k < 3; ++k) add(way[k], more.way[k]);
  }
};

MarkerField::MarkerField(const MarkerParameters& form, RandomKey key, Obstacles obstacles)
    : form_(form), key_(key), obstacles_(std::move(obstacles)), bricks_(form.spacing, form.occupancy, key) {}

std::uint32_t MarkerField::add_volume(CrownPointer crown, Vec3 root) {
  volumes_.push_back({std::move(crown), root});
  for (std::size_t k = 0; k < bricks_.brick_count(); ++k) limit(bricks_.brick(static_cast<std::uint32_t>(k)));
  return static_cast<std::uint32_t>(volumes_.size() - 1);
}

MarkerField MarkerField::vacant() const {
  MarkerField vacant(form_, key_, obstacles_);
  vacant.volumes_ = volumes_;
  return vacant;
}

DVec3 MarkerField::position(const MarkerBricks::Cell& brick, std::uint8_t pattern, std::uint32_t marker) const {
  const MarkerBricks::Pattern& at = bricks_.pattern(pattern);
  const DVec3 corner(brick[0], brick[1], brick[2]);
  return form_.spacing * (double{MarkerBricks::kSide} * corner + DVec3(at.x[marker], at.y[marker], at.z[marker]));
}

std::uint64_t MarkerField::find_claim(const MarkerBricks::Cell& brick, std::uint8_t pattern,
                                      const Volume& volume) const {
  const Box crown = volume.crown ? volume.crown->bounds() : Box{};
  const Box bodies = obstacles_.bounds();
  std::uint64_t markers = 0;
  for (std::uint32_t k = 0; k < kInBrick; ++k) {
    const DVec3 exact = position(brick, pattern, k);
    const Vec3 in_crown(exact - DVec3(volume.root));
    if (volume.crown && !(crown.holds(in_crown) && volume.crown->contains(in_crown))) continue;
    const Vec3 position(exact);
    if (bodies.holds(position) && obstacles_.contain(position)) continue;
    markers |= 1ULL << k;
  }
  return markers;
}

const MarkerField::Claim* MarkerField::known_claim(const MarkerBricks::Brick& brick, std::uint32_t volume) const {
  for (std::uint32_t k = brick.claims; k != MarkerBricks::kNone; k = claims_[k].next) {
    if (claims_[k].volume == volume) return &claims_[k];
  }
  return nullptr;
}

/// Returns the free markers of a brick that a volume contains. If a brick is unknown to the volume, all markers count
/// as contained.
std::uint64_t MarkerField::seen_by(const MarkerBricks::Brick& brick, std::uint32_t volume) const {
  const Claim* const claim = known_claim(brick, volume);
  return claim == nullptr ? brick.free : brick.free & claim->markers;
}

void MarkerField::limit(MarkerBricks::Brick& brick) {
  std::uint64_t within = 0;
  std::size_t known = 0;
  for (std::uint32_t k = brick.claims; k != MarkerBricks::kNone; k = claims_[k].next, ++known)
    within |= claims_[k].markers;
  bricks_.limit(brick, known == volumes_.size() ? within : MarkerBricks::kAll);
}

/// Computes, for each brick and the volumes of the looks at it, which markers are in the volume.
void MarkerField::learn_claims(const LookedAt& looked, const Progress& progress) {
  struct Question {
    std::uint32_t brick;
    std::uint32_t volume;
    std::uint64_t markers = 0;
  };
  std::vector<Question> questions;
  for (std::size_t k = 0; k < looked.bricks.size(); ++k) {
    progress.check();
    const MarkerBricks::Brick& brick = bricks_.brick(looked.bricks[k]);
    const std::size_t first = questions.size();
    std::uint32_t last = MarkerBricks::kNone;
    for (const std::uint32_t looker : looked.lookers_at(k)) {
      const std::uint32_t volume = looked.looks[looker].volume;
      if (volume == std::exchange(last, volume)) continue;
      if ((!volumes_[volume].crown && obstacles_.empty()) || known_claim(brick, volume) != nullptr) continue;
      const auto is_same = [&](const Question& question) { return question.volume == volume; };
      if (std::none_of(questions.begin() + static_cast<std::ptrdiff_t>(first), questions.end(), is_same)) {
        questions.push_back({looked.bricks[k], volume});
      }
    }
  }
  parallel_for(questions.size(), kBrickGrain, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t k = begin; k < end; ++k) {
      const MarkerBricks::Brick& brick = bricks_.brick(questions[k].brick);
      questions[k].markers = find_claim(bricks_.place_of(brick), brick.pattern, volumes_[questions[k].volume]);
    }
  });
  for (const Question& question : questions) {
    MarkerBricks::Brick& brick = bricks_.brick(question.brick);
    claims_.push_back({question.markers, question.volume, brick.claims});
    brick.claims = static_cast<std::uint32_t>(claims_.size() - 1);
    limit(brick);
  }
}

/// Assigns each marker of a brick to its nearest look. Writes the sums of the looks, in their order, to `got`.
void MarkerField::share_out_brick(const MarkerBricks::Brick& brick, const LookedAt& looked,
                                  std::span<const std::uint32_t> lookers, std::vector<Tally>& got) const {
  got.assign(lookers.size(), {});
  if ((brick.free & brick.within) == 0) return;
  const MarkerBricks::Cell cell = bricks_.place_of(brick);
  const MarkerBricks::Pattern& pattern = bricks_.pattern(brick.pattern);
  const auto share = [&](std::uint64_t markers, bool among_yielding) {
    BrickContest contest;
    contest.begin(pattern, markers);
    std::uint32_t volume = MarkerBricks::kNone;
    for (std::uint32_t k = 0; k < lookers.size(); ++k) {
      const Look& look = looked.looks[lookers[k]];
      if (look.yields != among_yielding) continue;
      if (look.volume != std::exchange(volume, look.volume)) contest.show(pattern, seen_by(brick, volume));
      contest.compete(look, MarkerBricks::from_corner(cell, look.position), MarkerBricks::kSide * cell[2], k);
    }
    contest.for_each_owner([&](std::uint32_t owner, std::uint32_t marker, float square) {
      markers &= ~(1ULL << marker);
      ++got[owner].count;
      if (square == 0) return;
      const Vec3 from = MarkerBricks::from_corner(cell, looked.looks[lookers[owner]].position);
      const Vec3 way = Vec3(pattern.x[marker], pattern.y[marker], pattern.z[marker]) - from;
      const Vec3 unit = way / std::sqrt(square);
      for (int k = 0; k < 3; ++k) got[owner].way[k] += static_cast<std::int64_t>(kUnitLength * unit[k]);
    });
    return markers;
  };
  const std::uint64_t left = share(brick.free & brick.within, false);
  const auto yields = [&](std::uint32_t looker) { return looked.looks[looker].yields; };
  if (left != 0 && std::ranges::any_of(lookers, yields)) share(left, true);
}

void MarkerField::share_out(std::span<const SpaceSeeker> seekers, std::span<BudRoom> rooms, const Progress& progress,
                            std::uint64_t max_bytes) {
  if (seekers.size() != rooms.size()) throw std::invalid_argument("share_out: not as many rooms as seekers");
  const std::uint64_t max_sightings = std::min<std::uint64_t>(max_bytes / kBytesASighting, kMaxSightings);
  auto around = look_around(bricks_, seekers, volumes_.size(), max_sightings, progress);
  if (!around) throw TooMuchMemory();
  const LookedAt looked = looked_at(bricks_, std::move(*around), progress);
  learn_claims(looked, progress);

  std::vector<Tally> tallies(looked.looks.size());
  parallel_for(looked.bricks.size(), kBrickGrain, [&](std::size_t begin, std::size_t end) {
    progress.check();
    std::vector<Tally> got;
    for (std::size_t k = begin; k < end; ++k) {
      const std::span<const std::uint32_t> lookers = looked.lookers_at(k);
      share_out_brick(bricks_.brick(looked.bricks[k]), looked, lookers, got);
      for (std::size_t i = 0; i < lookers.size(); ++i) {
        if (got[i].count > 0) tallies[lookers[i]].raise(got[i]);
      }
    }
  });

  std::fill(rooms.begin(), rooms.end(), BudRoom());
  for (std::size_t k = 0; k < tallies.size(); ++k) {
    const Tally& tally = tallies[k];
    const DVec3 way(static_cast<double>(tally.way[0]), static_cast<double>(tally.way[1]),
                    static_cast<double>(tally.way[2]));
    rooms[looked.looks[k].seeker] = {.count = tally.count, .way = Vec3(way / double{kUnitLength})};
  }
}

std::vector<DVec3> MarkerField::free_markers(const Box& box, std::uint32_t volume) const {
  std::vector<DVec3> markers;
  const Volume& own = volumes_.at(volume);
  const auto brick_at = [&](Vec3 corner) {
    return MarkerBricks::holder(MarkerBricks::voxels(bricks_.fine(corner), Vec3(0), Vec3(0)).low);
  };
  const MarkerBricks::Range range{brick_at(box.low), brick_at(box.high)};
  MarkerBricks::Recent recent;
  for (std::int32_t z = range.low[2]; z <= range.high[2]; ++z) {
    for (std::int32_t y = range.low[1]; y <= range.high[1]; ++y) {
      for (std::int32_t x = range.low[0]; x <= range.high[0]; ++x) {
        const MarkerBricks::Cell cell{x, y, z};
        const std::uint8_t pattern = bricks_.pattern_at(cell);
        std::uint64_t free = find_claim(cell, pattern, own);
        const std::uint32_t block = bricks_.find_block(MarkerBricks::holder(cell), recent);
        if (block != MarkerBricks::kNone) {
          const std::uint32_t brick = bricks_.block(block).bricks[MarkerBricks::number(cell)];
          if (brick != MarkerBricks::kNone) free &= bricks_.brick(brick).free;
        }
        for (; free != 0; free &= free - 1) {
          const DVec3 marker = position(cell, pattern, static_cast<std::uint32_t>(std::countr_zero(free)));
          if (box.holds(Vec3(marker))) markers.push_back(marker);
        }
      }
    }
  }
  return markers;
}

std::size_t MarkerField::bytes() const {
  return bricks_.bytes() + claims_.size() * sizeof(Claim) + volumes_.size() * sizeof(Volume);
}

}  // namespace meristem
