// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/marker_look.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kGrain = 1024;
constexpr float kMargin = 0.02F;  // voxels, more than any rounding here

using BrickPlace = MarkerBricks::BrickPlace;
using BrickRange = MarkerBricks::BrickRange;

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
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
    for (int k = 0; k < 3; ++k) {
      range_.low[k] = end(-radius * farthest(-direction[k]) - kMargin, k);
      range_.high[k] = end(radius * farthest(direction[k]) + kMargin, k);
    }
  }

  /// The bricks that meet the box around the cone.
  const BrickRange& range() const { return range_; }

  /// False only if no marker of the brick can be in the cone.
  bool may_reach(const BrickPlace& brick) const {
    constexpr float kHalf = 0.5F * MarkerBricks::kSide;
    const Vec3 middle = kHalf - MarkerBricks::from_corner(brick, tip_);
    const Vec3 outside = glm::max(glm::abs(middle) - kHalf, Vec3(0));
    if (squared_length(outside) > square_) return false;
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
  /// How far a cone of length 1 reaches along an axis, given the cosine of its direction to it: 0 if it leads away.
  float farthest(float along) const {
    if (along >= cosine_) return 1;
    return std::max(0.0F, along * cosine_ + std::sqrt(std::max(0.0F, 1 - along * along)) * sine_);
  }
  std::int32_t end(float voxels, int axis) const {
    return static_cast<std::int32_t>((tip_[axis] + static_cast<std::int64_t>(voxels * 65536)) >> 18);
  }

  MarkerBricks::FinePlace tip_;
  Vec3 direction_;
  float square_;
  float cosine_;
  float sine_;
  BrickRange range_;
};

template <class Visit>
void for_each_block(const BrickRange& range, Visit visit) {
  const BrickPlace low = MarkerBricks::block_of(range.low);
  const BrickPlace high = MarkerBricks::block_of(range.high);
  for (std::int32_t z = low[2]; z <= high[2]; ++z) {
    for (std::int32_t y = low[1]; y <= high[1]; ++y) {
      for (std::int32_t x = low[0]; x <= high[0]; ++x) visit(BrickPlace{x, y, z});
    }
  }
}

/// The sightings in a block.
void look_into(const MarkerBricks& bricks, std::uint32_t block, const Cone& cone, std::uint32_t look,
               std::vector<Sighting>& sightings) {
  const BrickPlace place = bricks.block(block).place;
  std::uint64_t open = bricks.block(block).open & MarkerBricks::bits_of(cone.range(), place);
  for (; open != 0; open &= open - 1) {
    const auto k = static_cast<std::uint32_t>(std::countr_zero(open));
    if (!cone.may_reach(MarkerBricks::brick_in(place, k))) continue;
    sightings.push_back({MarkerBricks::kInBrick * block + k, look});
  }
}

/// A block that a look would see, if it were there.
struct Missing {
  BrickPlace block;
  std::uint32_t look;
};

class Looker {
 public:
  Looker(const MarkerBricks& bricks, std::size_t volume_count) : bricks_(bricks), volume_count_(volume_count) {}

  void look(const Seeker& seeker, std::uint32_t index, LookAround& around, std::vector<Missing>& missing) {
    const auto spacing = static_cast<float>(bricks_.spacing());
    require(seeker.volume < volume_count_, "Seeker::volume is none that was added");
    require(seeker.radius >= 0 && seeker.radius <= MarkerBricks::kMostReach * spacing,
            "Seeker::radius is out of range");
    require(std::abs(seeker.cosine) <= 1, "Seeker::cosine is out of range");
    const float length = glm::length(seeker.direction);
    require(std::abs(length - 1) < 1e-3F, "Seeker::direction is no unit vector");
    const float radius = seeker.radius / spacing;
    const MarkerBricks::FinePlace place = bricks_.fine(seeker.place);
    if (!is_open(MarkerBricks::around(place, radius))) return;

    const Vec3 direction = seeker.direction / length;
    const Cone cone(place, direction, radius, seeker.cosine);
    const auto look = static_cast<std::uint32_t>(around.looks.size());
    const std::size_t before = around.sightings.size() + missing.size();
    for_each_block(cone.range(), [&](const BrickPlace& at) {
      const std::uint32_t block = bricks_.find_block(at, recent_);
      if (block == MarkerBricks::kNone) {
        missing.push_back({at, look});
      } else {
        look_into(bricks_, block, cone, look, around.sightings);
      }
    });
    if (around.sightings.size() + missing.size() == before) return;
    around.looks.push_back(
        {place, direction, radius * radius, seeker.cosine * std::abs(seeker.cosine), seeker.volume, index});
  }

 private:
  bool is_open(const BrickRange& range) {
    std::uint64_t open = 0;
    for_each_block(range, [&](const BrickPlace& at) {
      if (open != 0) return;
      const std::uint32_t block = bricks_.find_block(at, recent_);
      open = block == MarkerBricks::kNone ? MarkerBricks::kAll
                                          : bricks_.block(block).open & MarkerBricks::bits_of(range, at);
    });
    return open != 0;
  }

  const MarkerBricks& bricks_;
  std::size_t volume_count_;
  MarkerBricks::Recent recent_;
};

}  // namespace

std::vector<LookAround> look_around(MarkerBricks& bricks, std::span<const Seeker> seekers, std::size_t volume_count,
                                    const Progress& progress) {
  const std::size_t parts = (seekers.size() + kGrain - 1) / kGrain;
  std::vector<LookAround> around(parts);
  std::vector<std::vector<Missing>> missing(parts);
  parallel_for(seekers.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    progress.check();
    Looker looker(bricks, volume_count);
    const std::size_t part = begin / kGrain;
    for (std::size_t k = begin; k < end; ++k) {
      looker.look(seekers[k], static_cast<std::uint32_t>(k), around[part], missing[part]);
    }
  });

  // Where no block is, nobody has seen anything yet: so the order of each one's sightings stays that of the seekers.
  for (std::size_t part = 0; part < parts; ++part) {
    for (const Missing& each : missing[part]) {
      const Look& look = around[part].looks[each.look];
      const Cone cone(look.place, look.direction, std::sqrt(look.square), seekers[look.seeker].cosine);
      look_into(bricks, bricks.add_block(each.block), cone, each.look, around[part].sightings);
    }
  }
  return around;
}

}  // namespace meristem
