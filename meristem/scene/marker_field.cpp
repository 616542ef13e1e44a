// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/marker_field.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/scene/marker_look.h"

namespace meristem {

namespace {

constexpr std::uint32_t kInBrick = MarkerBricks::kInBrick;
constexpr std::uint32_t kNone = MarkerBricks::kNone;
constexpr double kOne = 4294967296;  // a unit vector's length as a whole number
constexpr std::size_t kBrickGrain = 32;
constexpr std::size_t kLookGrain = 4096;

/// What a look has got; whole numbers, so that the order of adding does not matter.
struct Tally {
  std::uint32_t count = 0;
  std::array<std::int64_t, 3> way{};
};

void add(Tally& sum, const Tally& more) {
  const auto raise = [](auto& number, auto by) { std::atomic_ref(number).fetch_add(by, std::memory_order_relaxed); };
  raise(sum.count, more.count);
  for (int k = 0; k < 3; ++k) raise(sum.way[k], more.way[k]);
}

}  // namespace

/// Who looks at which bricks, in one round.
struct MarkerField::Contest {
  Contest(MarkerBricks& bricks, const std::vector<LookAround>& around);

  std::vector<Look> looks;
  std::vector<std::uint32_t> bricks;   // that are looked at, in the order of the first look
  std::vector<std::uint32_t> begins;   // of each one's lookers, and an end
  std::vector<std::uint32_t> lookers;  // by brick, in the order of the looks
};

MarkerField::Contest::Contest(MarkerBricks& all, const std::vector<LookAround>& around) {
  std::size_t look_count = 0;
  std::size_t sighting_count = 0;
  for (const LookAround& part : around) {
    look_count += part.looks.size();
    sighting_count += part.sightings.size();
  }
  looks.reserve(look_count);
  lookers.resize(sighting_count);

  // Count the lookers of each brick.
  std::vector<std::uint32_t> rank;
  for (const LookAround& part : around) {
    looks.insert(looks.end(), part.looks.begin(), part.looks.end());
    for (const Sighting& sighting : part.sightings) {
      const std::uint32_t brick = all.add_brick(sighting.slot);
      if (brick >= rank.size()) rank.resize(std::max<std::size_t>(all.brick_count(), 2 * rank.size()), kNone);
      if (rank[brick] == kNone) {
        rank[brick] = static_cast<std::uint32_t>(bricks.size());
        bricks.push_back(brick);
        begins.push_back(0);
      }
      ++begins[rank[brick]];
    }
  }
  std::uint32_t end = 0;
  for (std::uint32_t& begin : begins) begin = std::exchange(end, end + begin);

  // Enter them; each begin moves on to the next one's.
  std::uint32_t first_look = 0;
  for (const LookAround& part : around) {
    for (const Sighting& sighting : part.sightings) {
      const std::uint32_t brick = all.add_brick(sighting.slot);
      lookers[begins[rank[brick]]++] = first_look + sighting.look;
    }
    first_look += static_cast<std::uint32_t>(part.looks.size());
  }
  begins.insert(begins.begin(), 0);
}

namespace {

/// The markers of one brick and the nearest looker to each so far.
class BrickContest {
 public:
  /// Of the markers `open`, those in `seen(volume)` can be seen by the lookers of a volume.
  void begin(const MarkerBricks::Pattern& pattern, std::uint64_t open) {
    count_ = 0;
    for (; open != 0; open &= open - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(open));
      marker_[count_] = k;
      x_[count_] = pattern.x[k];
      y_[count_] = pattern.y[k];
      z_[count_] = pattern.z[k];
      ++count_;
    }
    padded_ = (count_ + 7) / 8 * 8;
    for (std::uint32_t k = 0; k < padded_; ++k) {
      nearest_[k] = k < count_ ? std::numeric_limits<float>::infinity() : -1;
      owner_[k] = kNone;
    }
  }

  /// Of those from now on only these are to be seen.
  void show(std::uint64_t seen) {
    for (std::uint32_t k = 0; k < count_; ++k) limit_[k] = (seen >> marker_[k] & 1) != 0 ? kFar : -1;
    for (std::uint32_t k = count_; k < padded_; ++k) limit_[k] = -1;
  }

  void compete(const Look& look, Vec3 from, std::uint32_t looker) {
    const Vec3 to = look.direction;
    for (std::uint32_t k = 0; k < padded_; ++k) {
      const float x = x_[k] - from.x;
      const float y = y_[k] - from.y;
      const float z = z_[k] - from.z;
      const float square = (x * x + z * z) + y * y;
      const float along = to.x * x + to.y * y + to.z * z;
      const bool is_in = (square <= look.square) & (along * std::abs(along) >= look.slope * square);
      const bool is_nearer = is_in & (square < nearest_[k]) & (square < limit_[k]);
      nearest_[k] = is_nearer ? square : nearest_[k];
      owner_[k] = is_nearer ? looker : owner_[k];
    }
  }

  template <class Visit>
  void for_each_owned(Visit visit) const {
    for (std::uint32_t k = 0; k < count_; ++k) {
      if (owner_[k] != kNone) visit(owner_[k], Vec3(x_[k], y_[k], z_[k]), nearest_[k]);
    }
  }

 private:
  static constexpr float kFar = 1e9F;
  std::uint32_t count_ = 0;
  std::uint32_t padded_ = 0;
  std::array<std::uint32_t, kInBrick> marker_;
  alignas(16) std::array<float, kInBrick> x_{};
  alignas(16) std::array<float, kInBrick> y_{};
  alignas(16) std::array<float, kInBrick> z_{};
  alignas(16) std::array<float, kInBrick> nearest_;
  alignas(16) std::array<float, kInBrick> limit_;
  alignas(16) std::array<std::uint32_t, kInBrick> owner_;
};

}  // namespace

MarkerField::MarkerField(const MarkerForm& form, RandomKey key, Obstacles obstacles)
    : form_(form), obstacles_(std::move(obstacles)), bricks_(form.spacing, form.occupancy, key) {}

std::uint32_t MarkerField::add_volume(CrownPointer crown, Vec3 root) {
  volumes_.push_back({std::move(crown), root});
  for (std::size_t k = 0; k < bricks_.brick_count(); ++k) limit(bricks_.brick(static_cast<std::uint32_t>(k)));
  return static_cast<std::uint32_t>(volumes_.size() - 1);
}

DVec3 MarkerField::position(const MarkerBricks::BrickPlace& brick, std::uint8_t pattern, std::uint32_t marker) const {
  const MarkerBricks::Pattern& at = bricks_.pattern(pattern);
  const DVec3 corner(brick[0], brick[1], brick[2]);
  return form_.spacing * (double{MarkerBricks::kSide} * corner + DVec3(at.x[marker], at.y[marker], at.z[marker]));
}

std::uint64_t MarkerField::find_claim(const MarkerBricks::BrickPlace& brick, std::uint8_t pattern,
                                      const Volume& volume) const {
  const Box crown = volume.crown ? volume.crown->bounds() : Box{};
  const Box bodies = obstacles_.bounds();
  std::uint64_t markers = 0;
  for (std::uint32_t k = 0; k < kInBrick; ++k) {
    const DVec3 exact = position(brick, pattern, k);
    const Vec3 in_crown(exact - DVec3(volume.root));
    if (volume.crown && !(crown.holds(in_crown) && volume.crown->contains(in_crown))) continue;
    const Vec3 place(exact);
    if (bodies.holds(place) && obstacles_.contain(place)) continue;
    markers |= 1ULL << k;
  }
  return markers;
}

const MarkerField::Claim* MarkerField::known_claim(const MarkerBricks::Brick& brick, std::uint32_t volume) const {
  for (std::uint32_t k = brick.claims; k != kNone; k = claims_[k].next) {
    if (claims_[k].volume == volume) return &claims_[k];
  }
  return nullptr;
}

/// Where nothing is known of a brick, the volume is all of space.
std::uint64_t MarkerField::seen_by(const MarkerBricks::Brick& brick, std::uint32_t volume) const {
  const Claim* const claim = known_claim(brick, volume);
  return claim == nullptr ? brick.free : brick.free & claim->markers;
}

void MarkerField::limit(MarkerBricks::Brick& brick) {
  std::uint64_t within = 0;
  std::size_t known = 0;
  for (std::uint32_t k = brick.claims; k != kNone; k = claims_[k].next, ++known) within |= claims_[k].markers;
  bricks_.limit(brick, known == volumes_.size() ? within : MarkerBricks::kAll);
}

/// Finds out, for each brick and the volumes of those who look at it, which markers are in the volume.
void MarkerField::learn_claims(const Contest& contest, const Progress& progress) {
  struct Question {
    std::uint32_t brick;
    std::uint32_t volume;
    std::uint64_t markers = 0;
  };
  std::vector<Question> questions;
  for (std::size_t k = 0; k < contest.bricks.size(); ++k) {
    const MarkerBricks::Brick& brick = bricks_.brick(contest.bricks[k]);
    const std::size_t first = questions.size();
    std::uint32_t last = kNone;
    for (std::uint32_t i = contest.begins[k]; i < contest.begins[k + 1]; ++i) {
      const std::uint32_t volume = contest.looks[contest.lookers[i]].volume;
      if (volume == std::exchange(last, volume)) continue;
      if ((!volumes_[volume].crown && obstacles_.empty()) || known_claim(brick, volume) != nullptr) continue;
      const auto is_same = [&](const Question& question) { return question.volume == volume; };
      if (std::none_of(questions.begin() + static_cast<std::ptrdiff_t>(first), questions.end(), is_same)) {
        questions.push_back({contest.bricks[k], volume});
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

void MarkerField::share_out(std::span<const Seeker> seekers, std::span<Room> rooms, const Progress& progress) {
  if (seekers.size() != rooms.size()) throw std::invalid_argument("share_out: not as many rooms as seekers");
  const Contest contest(bricks_, look_around(bricks_, seekers, volumes_.size(), progress));
  learn_claims(contest, progress);

  // Brick by brick each marker to the nearest.
  std::vector<Tally> tallies(contest.looks.size());
  parallel_for(contest.bricks.size(), kBrickGrain, [&](std::size_t begin, std::size_t end) {
    progress.check();
    BrickContest here;
    std::vector<Tally> got;
    for (std::size_t k = begin; k < end; ++k) {
      const MarkerBricks::Brick& brick = bricks_.brick(contest.bricks[k]);
      if ((brick.free & brick.within) == 0) continue;
      const MarkerBricks::BrickPlace place = bricks_.place_of(brick);
      const std::span lookers(contest.lookers.data() + contest.begins[k], contest.begins[k + 1] - contest.begins[k]);
      here.begin(bricks_.pattern_of(brick), brick.free & brick.within);
      std::uint32_t volume = kNone;
      std::uint64_t seen = 0;
      for (std::uint32_t i = 0; i < lookers.size(); ++i) {
        const Look& look = contest.looks[lookers[i]];
        if (look.volume != volume) {
          volume = look.volume;
          seen = seen_by(brick, volume);
          here.show(seen);
        }
        if (seen != 0) here.compete(look, MarkerBricks::from_corner(place, look.place), i);
      }

      got.assign(lookers.size(), {});
      here.for_each_owned([&](std::uint32_t owner, Vec3 marker, float square) {
        const Look& look = contest.looks[lookers[owner]];
        Tally& tally = got[owner];
        ++tally.count;
        if (square == 0) return;
        const DVec3 way(marker - MarkerBricks::from_corner(place, look.place));
        const DVec3 unit = way * (kOne / std::sqrt(static_cast<double>(square)));
        for (int axis = 0; axis < 3; ++axis) tally.way[axis] += static_cast<std::int64_t>(unit[axis]);
      });
      for (std::size_t i = 0; i < lookers.size(); ++i) {
        if (got[i].count > 0) add(tallies[lookers[i]], got[i]);
      }
    }
  });

  std::fill(rooms.begin(), rooms.end(), Room{});
  for (std::size_t k = 0; k < tallies.size(); ++k) {
    const Tally& tally = tallies[k];
    const DVec3 way(static_cast<double>(tally.way[0]), static_cast<double>(tally.way[1]),
                    static_cast<double>(tally.way[2]));
    rooms[contest.looks[k].seeker] = {tally.count, Vec3(way / kOne)};
  }
}

std::vector<DVec3> MarkerField::free_markers(const Box& box, std::uint32_t volume) const {
  std::vector<DVec3> markers;
  const Volume& own = volumes_.at(volume);
  const MarkerBricks::BrickRange range{MarkerBricks::around(bricks_.fine(box.low), 0).low,
                                       MarkerBricks::around(bricks_.fine(box.high), 0).high};
  MarkerBricks::Recent recent;
  for (std::int32_t z = range.low[2]; z <= range.high[2]; ++z) {
    for (std::int32_t y = range.low[1]; y <= range.high[1]; ++y) {
      for (std::int32_t x = range.low[0]; x <= range.high[0]; ++x) {
        const MarkerBricks::BrickPlace place{x, y, z};
        const std::uint8_t pattern = bricks_.pattern_at(place);
        std::uint64_t free = find_claim(place, pattern, own);
        const std::uint32_t block = bricks_.find_block(MarkerBricks::block_of(place), recent);
        if (block != kNone) {
          const std::uint32_t brick = bricks_.block(block).bricks[(x & 3) | (y & 3) << 2 | (z & 3) << 4];
          if (brick != kNone) free &= bricks_.brick(brick).free;
        }
        for (; free != 0; free &= free - 1) {
          const DVec3 marker = position(place, pattern, static_cast<std::uint32_t>(std::countr_zero(free)));
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
