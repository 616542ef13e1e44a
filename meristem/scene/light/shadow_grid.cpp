// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/light/shadow_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace meristem {

namespace {

constexpr double kOne = 4294967296;  // one shade as a whole number
constexpr double kMostShade = 1e6;
constexpr double kFarthest = 1e10;  // voxels
constexpr int kDeepest = 64;
constexpr int kLongestReach = 4;  // so that what is looked at lies in two bricks each way
constexpr int kBits = 3;          // of a voxel's place in its brick
constexpr int kMask = 7;

/// To the nearest whole number, halves away from 0, so that both sides are alike.
std::int64_t rounded(double value) {
  const auto whole = static_cast<std::int64_t>(std::floor(std::abs(value) + 0.5));
  return value < 0 ? -whole : whole;
}

/// The axis along which the layers follow each other.
int main_axis(DVec3 toward_light) {
  const DVec3 size(std::abs(toward_light.x), std::abs(toward_light.y), std::abs(toward_light.z));
  if (size.y >= size.x && size.y >= size.z) return 1;
  return size.x >= size.z ? 0 : 2;
}

std::size_t index_in_brick(std::int64_t x, std::int64_t y, std::int64_t z) {
  return static_cast<std::size_t>((x & kMask) | (y & kMask) << kBits | (z & kMask) << (2 * kBits));
}

double as_number(std::uint64_t shade) { return static_cast<double>(static_cast<std::int64_t>(shade)); }

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

void check(const ShadowForm& form) {
  require(form.voxel > 0 && std::isfinite(form.voxel), "ShadowForm::voxel is not above 0");
  require(form.amount >= 0 && form.amount <= kMostShade, "ShadowForm::amount is out of range");
  require(form.base >= 1 && std::isfinite(form.base), "ShadowForm::base is below 1");
  require(form.depth >= 0 && form.depth <= kDeepest, "ShadowForm::depth is out of range");
  require(form.reach >= 1 && form.reach <= kLongestReach, "ShadowForm::reach is out of range");
  const DVec3 light(form.toward_light);
  require(std::abs(glm::dot(light, light) - 1) < 1e-3, "ShadowForm::toward_light is no unit vector");
}

}  // namespace

std::size_t ShadowGrid::Hash::operator()(const BrickPlace& place) const {
  std::uint64_t bits = 0;
  for (const std::int32_t k : place) {
    bits = (bits ^ static_cast<std::uint32_t>(k)) * 0x9E3779B97F4A7C15U;
    bits ^= bits >> 32;
  }
  return bits;
}

ShadowGrid::ShadowGrid(const ShadowForm& form) : form_(form) {
  check(form);

  // The pyramid's layers: each a step away from the light, and aside as far as the light leans.
  const DVec3 light(form.toward_light);
  const int main = main_axis(light);
  double shade = form.amount;
  for (int q = 0; q <= form.depth; ++q) {
    Layer layer;
    layer.shade = shade;
    for (int k = 0; k < 3; ++k) {
      const auto middle = static_cast<int>(rounded(-q * light[k] / std::abs(light[main])));
      const int half = k == main ? 0 : q;
      layer.block.low[k] = middle - half;
      layer.block.high[k] = middle + half;
      bounds_.low[k] = std::min(bounds_.low[k], layer.block.low[k]);
      bounds_.high[k] = std::max(bounds_.high[k], layer.block.high[k]);
    }
    layers_.push_back(layer);
    shade /= form.base;
  }

  // The voxels around, one of each pair of opposites: all 26 neighbours, and with more reach a ball.
  const int reach = form.reach;
  for (int x = 0; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      for (int z = -reach; z <= reach; ++z) {
        const bool is_first = x > 0 || y > 0 || (y == 0 && z > 0);
        const int square = x * x + y * y + z * z;
        if (!is_first || square > std::max(reach * reach, 3)) continue;
        neighbours_.push_back({{x, y, z}, DVec3(x, y, z) / std::sqrt(square)});
      }
    }
  }
}

ShadowGrid::Voxel ShadowGrid::voxel_at(Vec3 place) const {
  Voxel voxel;
  for (int k = 0; k < 3; ++k) {
    const double at = std::floor(static_cast<double>(place[k]) / form_.voxel);
    require(std::abs(at) <= kFarthest, "a position is too far away for its shade");
    voxel[k] = static_cast<std::int64_t>(at);
  }
  return voxel;
}

bool ShadowGrid::reaches(Vec3 place) const {
  const double farthest = kFarthest * form_.voxel;
  return std::abs(place.x) <= farthest && std::abs(place.y) <= farthest && std::abs(place.z) <= farthest;
}

void ShadowGrid::change(Vec3 place, double weight, int sign) {
  require(std::abs(weight) * form_.amount <= kMostShade, "the weight of a shader is out of range");
  const Voxel shader = voxel_at(place);
  std::array<std::uint64_t, kDeepest + 1> amounts;
  for (std::size_t q = 0; q < layers_.size(); ++q) {
    amounts[q] = static_cast<std::uint64_t>(sign * rounded(weight * layers_[q].shade * kOne));
  }
  BrickPlace low;
  BrickPlace high;
  for (int k = 0; k < 3; ++k) {
    low[k] = static_cast<std::int32_t>((shader[k] + bounds_.low[k]) >> kBits);
    high[k] = static_cast<std::int32_t>((shader[k] + bounds_.high[k]) >> kBits);
  }
  for (std::int32_t z = low[2]; z <= high[2]; ++z) {
    for (std::int32_t y = low[1]; y <= high[1]; ++y) {
      for (std::int32_t x = low[0]; x <= high[0]; ++x) change_brick({x, y, z}, shader, amounts.data());
    }
  }
}

void ShadowGrid::change_brick(const BrickPlace& place, const Voxel& shader, const std::uint64_t* amounts) {
  std::array<int, 3> from;  // the shader's voxel to the brick's first
  for (int k = 0; k < 3; ++k) from[k] = static_cast<int>(std::int64_t{place[k]} * kSide - shader[k]);
  Brick* brick = nullptr;
  for (std::size_t q = 0; q < layers_.size(); ++q) {
    // The part of the layer that lies in the brick.
    Block part;
    bool is_empty = amounts[q] == 0;
    for (int k = 0; k < 3; ++k) {
      part.low[k] = std::max(layers_[q].block.low[k] - from[k], 0);
      part.high[k] = std::min(layers_[q].block.high[k] - from[k], kSide - 1);
      is_empty = is_empty || part.low[k] > part.high[k];
    }
    if (is_empty) continue;
    if (brick == nullptr) brick = &bricks_[place];
    change_block(*brick, part, amounts[q]);
  }
  // The sum may wrap to 0 over voxels that are not.
  if (brick == nullptr || brick->sum != 0) return;
  const auto& shade = brick->shade;
  if (std::all_of(shade.begin(), shade.end(), [](std::uint64_t s) { return s == 0; })) bricks_.erase(place);
}

void ShadowGrid::change_block(Brick& brick, const Block& block, std::uint64_t amount) {
  const int width = block.high[0] - block.low[0] + 1;
  for (int z = block.low[2]; z <= block.high[2]; ++z) {
    for (int y = block.low[1]; y <= block.high[1]; ++y) {
      std::uint64_t* const row = brick.shade.data() + index_in_brick(block.low[0], y, z);
      for (int x = 0; x < width; ++x) row[x] += amount;
      brick.sum += amount * static_cast<std::uint64_t>(width);
    }
  }
}

double ShadowGrid::shade(Vec3 place) const {
  const Voxel voxel = voxel_at(place);
  const auto found =
      bricks_.find({static_cast<std::int32_t>(voxel[0] >> kBits), static_cast<std::int32_t>(voxel[1] >> kBits),
                    static_cast<std::int32_t>(voxel[2] >> kBits)});
  if (found == bricks_.end()) return 0;
  return as_number(found->second.shade[index_in_brick(voxel[0], voxel[1], voxel[2])]) / kOne;
}

Vec3 ShadowGrid::brighter_way(Vec3 place) const {
  const Voxel voxel = voxel_at(place);

  // Look up the bricks around once.
  BrickPlace first;
  BrickPlace last;
  for (int k = 0; k < 3; ++k) {
    first[k] = static_cast<std::int32_t>((voxel[k] - form_.reach) >> kBits);
    last[k] = static_cast<std::int32_t>((voxel[k] + form_.reach) >> kBits);
  }
  std::array<const Brick*, 8> bricks{};
  for (int k = 0; k < 8; ++k) {
    const BrickPlace at{first[0] + (k & 1), first[1] + (k >> 1 & 1), first[2] + (k >> 2)};
    if (at[0] > last[0] || at[1] > last[1] || at[2] > last[2]) continue;
    const auto found = bricks_.find(at);
    if (found != bricks_.end()) bricks[k] = &found->second;
  }
  const auto shade_at = [&](std::int64_t x, std::int64_t y, std::int64_t z) -> std::uint64_t {
    const Brick* const brick =
        bricks[((x >> kBits) - first[0]) | ((y >> kBits) - first[1]) << 1 | ((z >> kBits) - first[2]) << 2];
    return brick == nullptr ? 0 : brick->shade[index_in_brick(x, y, z)];
  };

  // Opposite voxels together, so that what is equal on both sides leaves nothing.
  DVec3 sum(0);
  double total = 0;
  for (const auto& [offset, toward] : neighbours_) {
    const std::uint64_t there = shade_at(voxel[0] + offset[0], voxel[1] + offset[1], voxel[2] + offset[2]);
    const std::uint64_t opposite = shade_at(voxel[0] - offset[0], voxel[1] - offset[1], voxel[2] - offset[2]);
    sum += as_number(opposite - there) * toward;
    total += as_number(there) + as_number(opposite);
  }
  return total > 0 ? Vec3(sum / total) : Vec3(0);
}

std::size_t ShadowGrid::bytes() const {
  constexpr std::size_t kLinks = 2 * sizeof(void*);  // of the map
  return bricks_.size() * (sizeof(decltype(bricks_)::value_type) + kLinks);
}

}  // namespace meristem
