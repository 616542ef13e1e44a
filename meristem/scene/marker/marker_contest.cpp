// SPDX-License-Identifier: Apache-2.0
// Finds the nearest look at each marker of a round. Each brick is processed once with all looks that may see it.
#include "meristem/scene/marker/marker_contest.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace meristem {

namespace {

/// Logical and/or without branches, which would prevent vectorisation.
constexpr bool both(bool a, bool b) { return a & b; }
constexpr bool either(bool a, bool b) { return a | b; }

constexpr float kUnseen = 1e18F;  // coordinate of markers that no look can see

}  // namespace

LookedAt looked_at(MarkerBricks& bricks, std::vector<LookAround> around, const Progress& progress) {
  LookedAt all;
  std::size_t look_count = 0;
  std::size_t sighting_count = 0;
  for (const LookAround& part : around) {
    look_count += part.looks.size();
    sighting_count += part.sightings.size();
  }
  all.looks.reserve(look_count);

  // Count the looks at each brick.
  std::vector<std::uint32_t> ranks(MarkerBricks::kInBrick * bricks.block_count(), MarkerBricks::kNone);
  std::vector<std::uint32_t> look_counts;
  for (LookAround& part : around) {
    progress.check();
    all.looks.insert(all.looks.end(), part.looks.begin(), part.looks.end());
    look_counts.push_back(static_cast<std::uint32_t>(part.looks.size()));
    part.looks = {};  // free memory early: large stands need most of their memory here
    for (const Sighting& sighting : part.sightings) {
      std::uint32_t& rank = ranks[sighting.slot];
      if (rank == MarkerBricks::kNone) {
        rank = static_cast<std::uint32_t>(all.bricks.size());
        all.bricks.push_back(bricks.add_brick(sighting.slot));
        all.begins.push_back(0);
      }
      ++all.begins[rank];
    }
  }
  std::uint32_t end = 0;
  for (std::uint32_t& begin : all.begins) begin = std::exchange(end, end + begin);

  // Fill in the looks. Each begin moves on to the begin of the next brick.
  all.lookers.resize(sighting_count);
  std::uint32_t first_look = 0;
  for (std::size_t k = 0; k < around.size(); ++k) {
    progress.check();
    LookAround& part = around[k];
    for (const Sighting& sighting : part.sightings) {
      all.lookers[all.begins[ranks[sighting.slot]]++] = first_look + sighting.look;
    }
    first_look += look_counts[k];
    part.sightings = {};
  }
  all.begins.insert(all.begins.begin(), 0);
  return all;
}

void BrickContest::begin(const MarkerBricks::Pattern& pattern, std::uint64_t markers) {
  for (std::uint32_t layer = 0; layer < layers_.size(); ++layer) {
    const std::uint64_t below = layer < MarkerBricks::kSide ? (1ULL << 16 * layer) - 1 : MarkerBricks::kAll;
    layers_[layer] = static_cast<std::uint32_t>(std::popcount(markers & below));
  }
  count_ = 0;
  for (; markers != 0; markers &= markers - 1) {
    const auto k = static_cast<std::uint32_t>(std::countr_zero(markers));
    marker_[count_] = k;
    y_[count_] = pattern.y[k];
    z_[count_] = pattern.z[k];
    ++count_;
  }
  for (std::uint32_t k = count_; k < (count_ + kLanes - 1) / kLanes * kLanes; ++k) {
    x_[k] = kUnseen;
    y_[k] = 0;
    z_[k] = 0;
  }
  nearest_.fill(std::numeric_limits<float>::infinity());
  seeker_.fill(MarkerBricks::kNone);
  owner_.fill(MarkerBricks::kNone);
}

void BrickContest::show(const MarkerBricks::Pattern& pattern, std::uint64_t markers) {
  for (std::uint32_t k = 0; k < count_; ++k) {
    x_[k] = (markers >> marker_[k] & 1) != 0 ? pattern.x[marker_[k]] : kUnseen;
  }
}

void BrickContest::compete(const Look& look, Vec3 position, std::int32_t layer, std::uint32_t looker) {
  const std::uint32_t begin = layers_[std::clamp(look.low - layer, 0, MarkerBricks::kSide)] / kLanes * kLanes;
  const std::uint32_t end = layers_[std::clamp(look.high - layer + 1, 0, MarkerBricks::kSide)];
  const std::uint32_t trips = (end - begin + kLanes - 1) / kLanes * kLanes;
  // GCC vectorises this loop by four if signs are not chosen by a condition.
  const Vec3 to = look.direction;
  const float max = look.square;
  const float slope = look.slope;
  const std::uint32_t seeker = look.seeker;
  for (std::uint32_t k = begin; k < begin + trips; ++k) {
    const float x = x_[k] - position.x;
    const float y = y_[k] - position.y;
    const float z = z_[k] - position.z;
    const float square = (x * x + z * z) + y * y;
    const float along = to.x * x + to.y * y + to.z * z;
    const bool is_seen = both(square <= max, along * std::abs(along) >= slope * square);
    const bool is_first = both(square == nearest_[k], seeker < seeker_[k]);
    const bool is_owner = both(is_seen, either(square < nearest_[k], is_first));
    nearest_[k] = is_owner ? square : nearest_[k];
    seeker_[k] = is_owner ? seeker : seeker_[k];
    owner_[k] = is_owner ? looker : owner_[k];
  }
}

}  // namespace meristem
