// SPDX-License-Identifier: Apache-2.0
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, section 3.3 (equation 3.12 with the height where it prints x). The source rejects points of a box that lie
// outside; inverting the cumulated volume needs no trials, so the k-th point depends on its own draws only.
#include "meristem/scene/crown.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"

namespace meristem {
namespace {

constexpr int kSlices = 4096;         // in height; within one, points are uniform
constexpr std::size_t kGrain = 4096;  // points a block

Curve radius_over_height(const std::vector<Vec2>& profile) {
  if (profile.size() < 2) throw std::invalid_argument("crown profile: at least two points wanted");
  std::vector<Vec2> points;
  points.reserve(profile.size());
  for (const Vec2 marked : profile) points.emplace_back(marked.y, marked.x);
  return Curve(std::move(points));
}

}  // namespace

ProfileCrown::ProfileCrown(const std::vector<Vec2>& profile) : radius_(radius_over_height(profile)) {
  const double slice = (highest() - lowest()) / kSlices;
  const auto section = [this](double height) {
    const double radius = radius_at(height);
    return kPi * radius * radius;
  };
  heights_.reserve(kSlices + 1);
  cumulated_.reserve(kSlices + 1);
  // Sum the slices' volumes by Simpson's rule.
  double below = section(lowest());
  for (int k = 0; k <= kSlices; ++k) {
    heights_.push_back(k == kSlices ? highest() : lowest() + k * slice);
    cumulated_.push_back(volume_);
    if (k == kSlices) break;
    const double above = section(k + 1 == kSlices ? highest() : lowest() + (k + 1) * slice);
    volume_ += slice / 6 * (below + 4 * section(lowest() + (k + 0.5) * slice) + above);
    below = above;
  }
}

double ProfileCrown::lowest() const { return radius_.points().front().x; }

double ProfileCrown::highest() const { return radius_.points().back().x; }

double ProfileCrown::radius_at(double height) const {
  if (height < lowest() || height > highest()) return 0;
  return std::max(0.0, radius_(height));
}

bool ProfileCrown::contains(Vec3 point) const {
  if (point.y < lowest() || point.y > highest()) return false;
  const double radius = radius_at(point.y);
  const double x = point.x;
  const double z = point.z;
  return x * x + z * z <= radius * radius;
}

std::vector<Vec3> ProfileCrown::sample(std::uint64_t count, RandomKey key, Progress& progress) const {
  if (count > 0 && !(volume_ > 0)) throw std::invalid_argument("crown profile: no volume to sample");
  const RandomKey height_key = key.child("height");
  const RandomKey disc_key = key.child("disc");
  std::vector<Vec3> points(count);
  progress.begin("placing points", count);
  parallel_for(count, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      // Find the height below which this share of the volume lies.
      const double below = volume_ * height_key.uniform(k);
      const auto above = std::upper_bound(cumulated_.begin() + 1, cumulated_.end() - 1, below);
      const std::size_t slice = static_cast<std::size_t>(above - cumulated_.begin()) - 1;
      const double volume = cumulated_[slice + 1] - cumulated_[slice];
      const double share = volume > 0 ? (below - cumulated_[slice]) / volume : 0;
      const auto height = static_cast<float>(heights_[slice] + share * (heights_[slice + 1] - heights_[slice]));
      // Place the point uniformly in the disc there.
      const double distance = radius_at(height) * std::sqrt(disc_key.uniform(k, 0));
      const double angle = 2 * kPi * disc_key.uniform(k, 1);
      points[k] = Vec3(distance * math::cos(angle), height, distance * math::sin(angle));
    }
    progress.advance(end - begin);
  });
  return points;
}

}  // namespace meristem
