// SPDX-License-Identifier: Apache-2.0
// Dart throwing: a trial is kept if no point kept before is nearer than the spacing. The spacing begins at the distance
// at which random spheres would fill 0.3 of the crown (they jam at 0.38, and close to that nearly all trials fail) and
// shrinks a little whenever many trials in a row fail, so that the wanted number is always reached.
// Based on: R. Cook, Stochastic sampling in computer graphics (1986); B. Widom, Random sequential addition of hard
// spheres to a volume (1966).
#include "meristem/scene/blue_noise.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace meristem {

namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
constexpr double kFilled = 0.3;
constexpr int kMostMisses = 40;  // in a row
constexpr float kShrink = 0.97F;
constexpr std::size_t kLeastBatch = 256;
constexpr std::size_t kMostBatch = 1U << 16;

/// The cube root, by Newton's steps from above: exact arithmetic only, and not in any inner loop.
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
    if (!sampler.append(std::clamp<std::size_t>(2 * (count - kept), kLeastBatch, kMostBatch), progress, darts)) {
      return false;
    }
    if (kept == 0 && misses == 0) {
      const double spacing = cube_root(kFilled * 6 / kPi * sampler.volume() / static_cast<double>(count));
      begin_group(spacing, points.size() + count, points);
    }
    const std::uint64_t before = kept;
    for (const Vec3 dart : darts) {
      if (kept == count) break;
      if (is_free(dart, points)) {
        insert(static_cast<std::uint32_t>(points.size()), dart);
        points.push_back(dart);
        ++kept;
        misses = 0;
      } else if (++misses == kMostMisses) {
        present_spacing_ *= kShrink;
        misses = 1;
      }
    }
    progress.advance(kept - before);
  }
  return true;
}

/// Sorts all points so far into cells that fit the new group's spacing.
void BlueNoise::begin_group(double spacing, std::size_t expected, const std::vector<Vec3>& points) {
  present_spacing_ = static_cast<float>(spacing);
  cell_size_ = std::max(spacing, 1e-9);
  first_.assign(std::bit_ceil(std::max<std::size_t>(2 * expected, 16)), kNone);
  next_.clear();
  std::vector<float> spacings;
  spacings.swap(spacing_);
  for (std::size_t k = 0; k < points.size(); ++k) {
    insert(static_cast<std::uint32_t>(k), points[k]);
    spacing_[k] = spacings[k];
  }
}

void BlueNoise::insert(std::uint32_t index, Vec3 point) {
  const std::size_t home = bucket(cell(point.x), cell(point.y), cell(point.z));
  spacing_.push_back(present_spacing_);
  next_.push_back(first_[home]);
  first_[home] = index;
}

bool BlueNoise::is_free(Vec3 point, const std::vector<Vec3>& points) const {
  const std::int64_t x = cell(point.x);
  const std::int64_t y = cell(point.y);
  const std::int64_t z = cell(point.z);
  for (int k = 0; k < 27; ++k) {
    // A point may be met in several buckets that cells share; that costs time and nothing else.
    std::uint32_t other = first_[bucket(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1)];
    for (; other != kNone; other = next_[other]) {
      const Vec3 between = points[other] - point;
      const float apart = std::min(present_spacing_, spacing_[other]);
      if (glm::dot(between, between) < apart * apart) return false;
    }
  }
  return true;
}

std::int64_t BlueNoise::cell(float coordinate) const {
  return static_cast<std::int64_t>(std::floor(coordinate / cell_size_));
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
