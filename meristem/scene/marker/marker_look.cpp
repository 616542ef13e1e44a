// SPDX-License-Identifier: Apache-2.0
// Finds the bricks that each perception cone touches. Cones with many bricks are tested brick by brick; small cones are
// not, because testing their markers is faster.
#include "meristem/scene/marker/marker_look.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/base/require.h"

namespace meristem {

namespace {

constexpr std::size_t kGrain = 1024;
constexpr std::size_t kAtOnce = 16;  // seekers that are fetched together
// For fewer bricks in the box around a cone, testing each brick against the cone takes longer than testing its markers.
constexpr int kMaxUntested = 48;
constexpr float kMargin = 0.125F;  // voxels; larger than any rounding error here

using Cell = MarkerBricks::Cell;
using Range = MarkerBricks::Range;

void check(const SpaceSeeker& seeker, double spacing, std::size_t volume_count) {
  require(seeker.volume < volume_count, "Seeker::volume is none that was added");
  require(seeker.radius >= 0 && seeker.radius <= MarkerBricks::kMaxReach * spacing, "Seeker::radius is out of range");
  require(std::abs(seeker.cosine) <= 1, "Seeker::cosine is out of range");
  require(std::abs(squared_length(seeker.direction) - 1) < 1e-5F, "Seeker::direction is not a unit vector");
}

/// Tests bricks against a perception cone.
class Cone {
 public:
  Cone(const MarkerBricks::FinePosition& tip, Vec3 direction, float radius, float cosine)
      : direction_(direction),
        square_((radius + kMargin) * (radius + kMargin)),
        cosine_(cosine),
        sine_(std::sqrt(std::max(0.0F, 1 - cosine * cosine))) {
    Vec3 low;
    Vec3 high;
    for (int k = 0; k < 3; ++k) {
      const float aside = std::sqrt(std::max(0.0F, 1 - direction[k] * direction[k])) * sine_;
      low[k] = -radius * farthest(-direction[k], aside) - kMargin;
      high[k] = radius * farthest(direction[k], aside) + kMargin;
    }
    voxels_ = MarkerBricks::voxels(tip, low, high);
    bricks_ = MarkerBricks::holders(voxels_);
    first_middle_ = 0.5F * MarkerBricks::kSide - MarkerBricks::from_corner(bricks_.low, tip);
    int count = 1;
    for (int axis = 0; axis < 3; ++axis) {
      count *= bricks_.high[axis] - bricks_.low[axis] + 1;
      for (std::int32_t k = bricks_.low[axis]; k <= bricks_.high[axis]; ++k) {
        // The brick's voxels within the box, along this axis only.
        const int skipped = std::max(voxels_.low[axis] - MarkerBricks::kSide * k, 0);
        const int left = std::max(MarkerBricks::kSide * k + MarkerBricks::kSide - 1 - voxels_.high[axis], 0);
        parts_[axis][k - bricks_.low[axis]] = kOnes[axis] >> kStride[axis] * (skipped + left)
                                                                 << kStride[axis] * skipped;
      }
    }
    is_large_ = count > kMaxUntested;
  }

  /// The voxels and the bricks that touch the box around the cone.
  const Range& voxels() const { return voxels_; }
  const Range& bricks() const { return bricks_; }

  /// Returns true if the cone may contain one of the markers of a brick in bricks().
  bool may_see(std::uint64_t markers, const Cell& brick) const {
    const int x = brick[0] - bricks_.low[0];
    const int y = brick[1] - bricks_.low[1];
    const int z = brick[2] - bricks_.low[2];
    if ((markers & parts_[0][x] * parts_[1][y] * parts_[2][z]) == 0) return false;
    constexpr auto kStep = static_cast<float>(MarkerBricks::kSide);
    return !is_large_ || may_reach(first_middle_ + kStep * Vec3(x, y, z));
  }

 private:
  static constexpr std::array<std::uint64_t, 3> kOnes{0xF, 0x1111, 0x0001000100010001};
  static constexpr std::array<int, 3> kStride{1, 4, 16};

  /// Returns true if a brick may touch the cone. `middle` is the vector from the cone's tip to the brick's centre.
  bool may_reach(Vec3 middle) const {
    constexpr float kHalf = 0.5F * MarkerBricks::kSide;
    if (squared_length(glm::max(glm::abs(middle) - kHalf, Vec3(0))) > square_) return false;
    if (cosine_ < 0) return true;
    // The plane that touches the cone on the brick's side; its normal is scaled by the distance of the brick's centre
    // from the axis.
    const Vec3 aside = middle - glm::dot(direction_, middle) * direction_;
    const float distance = std::sqrt(squared_length(aside));
    const Vec3 normal = cosine_ * aside - sine_ * distance * direction_;
    const float reach = kHalf * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
    return glm::dot(normal, middle) <= reach + kMargin * (distance + kMargin);
  }

  /// Returns how far a cone of length 1 extends along an axis; 0 if it points away. `along` is the cosine between the
  /// cone's direction and the axis. `aside` is the sine between them times the sine of half the cone's angle.
  float farthest(float along, float aside) const {
    return along >= cosine_ ? 1 : std::max(0.0F, along * cosine_ + aside);
  }

  Vec3 direction_;
  float square_;
  float cosine_;
  float sine_;
  Range voxels_;
  Range bricks_;
  bool is_large_ = false;
  Vec3 first_middle_;  // vector from the tip to the centre of the first brick, voxels
  // Voxels of each brick that are in the box.
  std::array<std::array<std::uint64_t, MarkerBricks::kMaxAlong>, 3> parts_;
};

template <class Visit>
void for_each_place(const Range& range, Visit visit) {
  for (std::int32_t z = range.low[2]; z <= range.high[2]; ++z) {
    for (std::int32_t y = range.low[1]; y <= range.high[1]; ++y) {
      for (std::int32_t x = range.low[0]; x <= range.high[0]; ++x) visit(Cell{x, y, z});
    }
  }
}

/// A block that a look touches and that does not exist yet.
struct Missing {
  Cell block;
  std::uint32_t look;
};

/// Finds the sightings of seekers in bricks that do not change during the search.
class Looker {
 public:
  explicit Looker(const MarkerBricks& bricks) : bricks_(bricks) {}

  void look(const SpaceSeeker& seeker, std::uint32_t index, LookAround& around, std::vector<Missing>& missing) {
    const MarkerBricks::FinePosition place = bricks_.fine(seeker.position);
    const float radius = seeker.radius / static_cast<float>(bricks_.spacing());
    const Cone cone(place, seeker.direction, radius, seeker.cosine);
    const auto look = static_cast<std::uint32_t>(around.looks.size());
    const std::size_t before = around.sightings.size() + missing.size();
    for_each_place(MarkerBricks::holders(cone.bricks()), [&](const Cell& at) {
      const std::uint32_t block = bricks_.find_block(at, recent_);
      if (block == MarkerBricks::kNone) {
        missing.push_back({at, look});
      } else {
        look_into(block, cone, look, around.sightings);
      }
    });
    if (around.sightings.size() + missing.size() == before) return;
    around.looks.push_back({place, seeker.direction, radius * radius, seeker.cosine * std::abs(seeker.cosine),
                            cone.voxels().low[2], cone.voxels().high[2], seeker.volume, index, seeker.yields});
  }

  /// Adds the sightings in a block.
  void look_into(std::uint32_t number, const Cone& cone, std::uint32_t look, std::vector<Sighting>& sightings) const {
    const MarkerBricks::Block& block = bricks_.block(number);
    std::uint64_t open = block.open & MarkerBricks::held(block.position, cone.bricks());
    for (; open != 0; open &= open - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(open));
      if (!cone.may_see(block.markers[k], MarkerBricks::held(block.position, k))) continue;
      sightings.push_back({MarkerBricks::kInBrick * number + k, look});
    }
  }

 private:
  const MarkerBricks& bricks_;
  MarkerBricks::Recent recent_;
};

/// Returns the seekers ordered by brick. Creates the blocks of these bricks.
std::vector<std::uint32_t> spatial_order(MarkerBricks& bricks, std::span<const SpaceSeeker> seekers,
                                         std::size_t volume_count, const Progress& progress) {
  const auto brick_of = [&](const SpaceSeeker& seeker) {
    const MarkerBricks::FinePosition place = bricks.fine(seeker.position);
    return MarkerBricks::holder(MarkerBricks::voxels(place, Vec3(0), Vec3(0)).low);
  };
  std::vector<std::uint32_t> slots(seekers.size());
  parallel_for(seekers.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    progress.check();
    MarkerBricks::Recent recent;
    for (std::size_t k = begin; k < end; ++k) {
      check(seekers[k], bricks.spacing(), volume_count);
      const Cell brick = brick_of(seekers[k]);
      const std::uint32_t block = bricks.find_block(MarkerBricks::holder(brick), recent);
      slots[k] = block == MarkerBricks::kNone ? MarkerBricks::kNone
                                              : MarkerBricks::kInBrick * block + MarkerBricks::number(brick);
    }
  });
  for (std::size_t k = 0; k < seekers.size(); ++k) {
    if (slots[k] != MarkerBricks::kNone) continue;
    const Cell brick = brick_of(seekers[k]);
    slots[k] = MarkerBricks::kInBrick * bricks.add_block(MarkerBricks::holder(brick)) + MarkerBricks::number(brick);
  }

  std::vector<std::uint32_t> begins(MarkerBricks::kInBrick * bricks.block_count() + 1);
  for (const std::uint32_t slot : slots) ++begins[slot + 1];
  for (std::size_t k = 1; k < begins.size(); ++k) begins[k] += begins[k - 1];
  std::vector<std::uint32_t> order(seekers.size());
  for (std::size_t k = 0; k < seekers.size(); ++k) order[begins[slots[k]]++] = static_cast<std::uint32_t>(k);
  return order;
}

}  // namespace

std::optional<std::vector<LookAround>> look_around(MarkerBricks& bricks, std::span<const SpaceSeeker> seekers,
                                                   std::size_t volume_count, std::uint64_t max_sightings,
                                                   const Progress& progress) {
  const std::vector<std::uint32_t> order = spatial_order(bricks, seekers, volume_count, progress);
  const std::size_t parts = (seekers.size() + kGrain - 1) / kGrain;
  std::vector<LookAround> around(parts);
  std::vector<std::vector<Missing>> missing(parts);
  std::atomic<std::uint64_t> sightings{0};
  parallel_for(seekers.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    progress.check();
    if (sightings > max_sightings) return;
    Looker looker(bricks);
    const std::size_t part = begin / kGrain;
    // Fetch several seekers together, because each may cause a cache miss.
    std::array<SpaceSeeker, kAtOnce> fetched;
    for (std::size_t first = begin; first < end; first += kAtOnce) {
      const std::size_t count = std::min(kAtOnce, end - first);
      for (std::size_t k = 0; k < count; ++k) fetched[k] = seekers[order[first + k]];
      for (std::size_t k = 0; k < count; ++k) looker.look(fetched[k], order[first + k], around[part], missing[part]);
    }
    sightings += around[part].sightings.size() + missing[part].size();
  });
  if (sightings > max_sightings) return std::nullopt;

  // Create the missing blocks.
  for (std::size_t part = 0; part < parts; ++part) {
    progress.check();
    for (const Missing& each : missing[part]) {
      const std::uint32_t block = bricks.add_block(each.block);
      const Look& look = around[part].looks[each.look];
      const Cone cone(look.position, look.direction, std::sqrt(look.square), seekers[look.seeker].cosine);
      Looker(bricks).look_into(block, cone, each.look, around[part].sightings);
    }
  }
  return around;
}

}  // namespace meristem
