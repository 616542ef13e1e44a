// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/marker_look.h"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kGrain = 1024;
constexpr std::size_t kAtOnce = 16;
constexpr float kMargin = 0.125F;  // voxels, more than any rounding here

using Place = MarkerBricks::Place;
using Range = MarkerBricks::Range;

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

void check(const Seeker& seeker, double spacing, std::size_t volume_count) {
  require(seeker.volume < volume_count, "Seeker::volume is none that was added");
  require(seeker.radius >= 0 && seeker.radius <= MarkerBricks::kMostReach * spacing, "Seeker::radius is out of range");
  require(std::abs(seeker.cosine) <= 1, "Seeker::cosine is out of range");
  require(std::abs(squared_length(seeker.direction) - 1) < 1e-5F, "Seeker::direction is no unit vector");
}

/// A perception cone against bricks.
class Cone {
 public:
  Cone(const MarkerBricks::FinePlace& tip, Vec3 direction, float radius, float cosine)
      : tip_(tip),
        direction_(direction),
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
  }

  /// The voxels that meet the box around the cone.
  const Range& voxels() const { return voxels_; }

  /// False only if no marker of the brick can be in the cone.
  bool may_reach(const Place& brick) const {
    constexpr float kHalf = 0.5F * MarkerBricks::kSide;
    const Vec3 middle = kHalf - MarkerBricks::from_corner(brick, tip_);
    if (squared_length(glm::max(glm::abs(middle) - kHalf, Vec3(0))) > square_) return false;
    if (cosine_ < 0) return true;
    // The plane that touches the cone on the brick's side.
    const float along = glm::dot(direction_, middle);
    const Vec3 aside = middle - along * direction_;
    const float distance = std::sqrt(squared_length(aside));
    if (distance < kMargin) return true;
    const Vec3 normal = cosine_ / distance * aside - sine_ * direction_;
    const float reach = kHalf * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
    return glm::dot(normal, middle) <= reach + kMargin;
  }

 private:
  /// How far a cone of length 1 reaches along an axis: 0 if it leads away. Given the cosine between its direction and
  /// the axis, and their sine times that of half the cone's angle.
  float farthest(float along, float aside) const {
    return along >= cosine_ ? 1 : std::max(0.0F, along * cosine_ + aside);
  }

  MarkerBricks::FinePlace tip_;
  Vec3 direction_;
  float square_;
  float cosine_;
  float sine_;
  Range voxels_;
};

template <class Visit>
void for_each_place(const Range& range, Visit visit) {
  for (std::int32_t z = range.low[2]; z <= range.high[2]; ++z) {
    for (std::int32_t y = range.low[1]; y <= range.high[1]; ++y) {
      for (std::int32_t x = range.low[0]; x <= range.high[0]; ++x) visit(Place{x, y, z});
    }
  }
}

/// A block that a look would see, if it were there.
struct Missing {
  Place block;
  std::uint32_t look;
};

class Looker {
 public:
  explicit Looker(const MarkerBricks& bricks) : bricks_(bricks) {}

  void look(const Seeker& seeker, std::uint32_t index, LookAround& around, std::vector<Missing>& missing) {
    const MarkerBricks::FinePlace place = bricks_.fine(seeker.place);
    const float radius = seeker.radius / static_cast<float>(bricks_.spacing());
    const Cone cone(place, seeker.direction, radius, seeker.cosine);
    const auto look = static_cast<std::uint32_t>(around.looks.size());
    const std::size_t before = around.sightings.size() + missing.size();
    for_each_place(MarkerBricks::holders(MarkerBricks::holders(cone.voxels())), [&](const Place& at) {
      const std::uint32_t block = bricks_.find_block(at, recent_);
      if (block == MarkerBricks::kNone) {
        missing.push_back({at, look});
      } else {
        look_into(block, cone, look, around.sightings);
      }
    });
    if (around.sightings.size() + missing.size() == before) return;
    around.looks.push_back({place, seeker.direction, radius * radius, seeker.cosine * std::abs(seeker.cosine),
                            cone.voxels().low[2], cone.voxels().high[2], seeker.volume, index});
  }

  /// The sightings in a block.
  void look_into(std::uint32_t number, const Cone& cone, std::uint32_t look, std::vector<Sighting>& sightings) const {
    const MarkerBricks::Block& block = bricks_.block(number);
    std::uint64_t open = block.open & MarkerBricks::held(block.place, MarkerBricks::holders(cone.voxels()));
    for (; open != 0; open &= open - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(open));
      const Place brick = MarkerBricks::held(block.place, k);
      if ((block.markers[k] & MarkerBricks::held(brick, cone.voxels())) == 0 || !cone.may_reach(brick)) continue;
      sightings.push_back({MarkerBricks::kInBrick * number + k, look});
    }
  }

 private:
  const MarkerBricks& bricks_;
  MarkerBricks::Recent recent_;
};

/// Seekers by the bricks that they are in. Adds the blocks of these.
std::vector<std::uint32_t> spatial_order(MarkerBricks& bricks, std::span<const Seeker> seekers,
                                         std::size_t volume_count, const Progress& progress) {
  const auto brick_of = [&](const Seeker& seeker) {
    const MarkerBricks::FinePlace place = bricks.fine(seeker.place);
    return MarkerBricks::holder(MarkerBricks::voxels(place, Vec3(0), Vec3(0)).low);
  };
  std::vector<std::uint32_t> slots(seekers.size());
  parallel_for(seekers.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    progress.check();
    MarkerBricks::Recent recent;
    for (std::size_t k = begin; k < end; ++k) {
      check(seekers[k], bricks.spacing(), volume_count);
      const Place brick = brick_of(seekers[k]);
      const std::uint32_t block = bricks.find_block(MarkerBricks::holder(brick), recent);
      slots[k] = block == MarkerBricks::kNone ? MarkerBricks::kNone
                                              : MarkerBricks::kInBrick * block + MarkerBricks::number(brick);
    }
  });
  for (std::size_t k = 0; k < seekers.size(); ++k) {
    if (slots[k] != MarkerBricks::kNone) continue;
    const Place brick = brick_of(seekers[k]);
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

std::vector<LookAround> look_around(MarkerBricks& bricks, std::span<const Seeker> seekers, std::size_t volume_count,
                                    const Progress& progress) {
  const std::vector<std::uint32_t> order = spatial_order(bricks, seekers, volume_count, progress);
  const std::size_t parts = (seekers.size() + kGrain - 1) / kGrain;
  std::vector<LookAround> around(parts);
  std::vector<std::vector<Missing>> missing(parts);
  parallel_for(seekers.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    progress.check();
    Looker looker(bricks);
    const std::size_t part = begin / kGrain;
    // Fetched some at once, because each may have to come from afar.
    std::array<Seeker, kAtOnce> fetched;
    for (std::size_t first = begin; first < end; first += kAtOnce) {
      const std::size_t count = std::min(kAtOnce, end - first);
      for (std::size_t k = 0; k < count; ++k) fetched[k] = seekers[order[first + k]];
      for (std::size_t k = 0; k < count; ++k) looker.look(fetched[k], order[first + k], around[part], missing[part]);
    }
  });

  for (std::size_t part = 0; part < parts; ++part) {
    for (const Missing& each : missing[part]) {
      const std::uint32_t block = bricks.add_block(each.block);
      const Look& look = around[part].looks[each.look];
      const Cone cone(look.place, look.direction, std::sqrt(look.square), seekers[look.seeker].cosine);
      Looker(bricks).look_into(block, cone, each.look, around[part].sightings);
    }
  }
  return around;
}

}  // namespace meristem
