// SPDX-License-Identifier: Apache-2.0
// Places points with a minimum distance by dart throwing: a trial is kept if no kept point is nearer than the spacing.
// The initial spacing is the distance at which random spheres would fill 0.3 of the crown. (They jam at 0.38, and close
// to that nearly all trials fail.) The spacing shrinks a little whenever many trials in a row fail, so the requested
// number is always reached.
//
// Based on: R. Cook, Stochastic sampling in computer graphics (1986); B. Widom, Random sequential addition of hard
// spheres to a volume (1966).
#include "meristem/scene/crown/blue_noise.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace meristem {

namespace {

constexpr std::uint32_t kNoPoint = 0xffffffffU;
constexpr double kFilled = 0.3;
constexpr int kMaxMisses = 40;  // consecutive failed trials before the spacing shrinks
constexpr float kShrink = 0.97F;
constexpr std::size_t kMinBatch = 256;
constexpr std::size_t kMaxBatch = 1U << 16;

/// The 27 cells around a point, nearest first: its own cell, then those that share a side, an edge and a corner with
/// it.
constexpr std::array<std::array<int, 3>, 27> kNeighbours = [] {
  std::array<std::array<int, 3>, 27> cells{};
  std::size_t count = 0;
  for (int steps = 0; steps <= 3; ++steps) {
    for (int k = 0; k < 27; ++k) {
      const int x = k % 3 - 1;
      const int y = k / 3 % 3 - 1;
      const int z = k / 9 - 1;
      if (x * x + y * y + z * z != steps) continue;
      cells[count++] = {x, y, z};
    }
  }
  return cells;
}();

/// Returns the cube root by Newton's method from above. It uses exact arithmetic only and is too slow for inner loops.
double cube_root(double x) {
  double root = std::max(1.0, x);
  for (int k = 0; k < 200; ++k) {
    const double next = (2 * root + x / (root * root)) / 3;
    if (!(next < root)) break;
    root = next;
  }
  return root;
}

}  // namespace

bool BlueNoise::append(CrownSampler& sampler, std::uint64_t count, Progress& progress, std::vector<Vec3>& points) {
  std::vector<Vec3> darts;
  std::uint64_t kept = 0;
  int misses = 0;
  while (kept < count) {
    darts.clear();
    if (!sampler.append(std::clamp<std::size_t>(2 * (count - kept), kMinBatch, kMaxBatch), progress, darts)) {
      return false;
    }
    if (kept == 0 && misses == 0) {
      const double spacing = cube_root(kFilled * 6 / kPi * sampler.volume() / static_cast<double>(count));
      begin_group(spacing, count);
    }
    const std::uint64_t before = kept;
    for (const Vec3 dart : darts) {
      if (kept == count) break;
      if (is_free(dart)) {
        insert(dart, present_spacing_);
        points.push_back(dart);
        ++kept;
        misses = 0;
      } else if (++misses == kMaxMisses) {
        present_spacing_ *= kShrink;
        misses = 1;
      }
    }
    progress.advance(kept - before);
  }
  return true;
}

/// Sorts all points so far into cells that fit the spacing of the new group.
void BlueNoise::begin_group(double spacing, std::size_t expected) {
  present_spacing_ = static_cast<float>(spacing);
  cell_size_ = std::max(spacing, 1e-9);
  first_.assign(std::bit_ceil(std::max<std::size_t>(2 * (kept_.size() + expected), 16)), kNoPoint);
  std::vector<Kept> before;
  before.swap(kept_);
  for (const Kept& each : before) insert(each.point, each.spacing);
}

void BlueNoise::insert(Vec3 point, float spacing) {
  const DVec3 cell = glm::floor(DVec3(point) / cell_size_);
  const std::size_t home =
      bucket(static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y), static_cast<std::int64_t>(cell.z));
  kept_.push_back({point, spacing, first_[home]});
  first_[home] = static_cast<std::uint32_t>(kept_.size() - 1);
}

bool BlueNoise::is_free(Vec3 point) const {
  const DVec3 in_cells = DVec3(point) / cell_size_;
  const DVec3 cell = glm::floor(in_cells);
  const DVec3 within = in_cells - cell;
  const double reach = present_spacing_ / cell_size_;
  // Search from the point's own cell outward, because most rejected darts are too near to a point there.
  for (const std::array<int, 3>& step : kNeighbours) {
    double squared = 0;
    for (int k = 0; k < 3; ++k) {
      const int side = step[static_cast<std::size_t>(k)];
      const double gap = side == 0 ? 0 : side > 0 ? 1 - within[k] : within[k];
      squared += gap * gap;
    }
    if (squared > reach * reach) continue;
    // Cells may share a bucket, so a point may be tested several times. This costs time but does not change the result.
    std::uint32_t other =
        first_[bucket(static_cast<std::int64_t>(cell.x) + step[0], static_cast<std::int64_t>(cell.y) + step[1],
                      static_cast<std::int64_t>(cell.z) + step[2])];
    for (; other != kNoPoint; other = kept_[other].next) {
      const Vec3 between = kept_[other].point - point;
      const float apart = std::min(present_spacing_, kept_[other].spacing);
      if (glm::dot(between, between) < apart * apart) return false;
    }
  }
  return true;
}

std::size_t BlueNoise::bucket(std::int64_t x, std::int64_t y, std::int64_t z) const {
  std::uint64_t mixed = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U;
  mixed ^= static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4FU;
  mixed ^= static_cast<std::uint64_t>(z) * 0x165667B19E3779F9U;
  mixed ^= mixed >> 29U;
  mixed *= 0xBF58476D1CE4E5B9U;
  return (mixed >> 32U) & (first_.size() - 1);
}

}  // namespace meristem
