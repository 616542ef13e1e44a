// SPDX-License-Identifier: Apache-2.0
// Samples crowns by rejection: uniform points of the bounds are kept if the crown contains them. Trials are functions
// of their index, so blocks of trials run in parallel.
#include "meristem/scene/crown/crown_sampler.h"

#include <algorithm>

#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kTrialsPerBlock = 4096;
constexpr std::size_t kMaxTrials = 1U << 20;  // trials in one parallel loop
constexpr std::uint64_t kCheckTrials = 1U << 16;
constexpr std::uint64_t kCheckHits = 32;
// During growth, a crown fails only if it is much emptier than the check allows. A crown that passes the check
// therefore never fails by chance.
constexpr std::uint64_t kTrialsPerHit = 4 * kCheckTrials / kCheckHits;

Vec3 trial(const Box& box, RandomKey plan, RandomKey height, std::uint64_t index) {
  const DVec3 share(plan.uniform(index, 0), height.uniform(index), plan.uniform(index, 1));
  return Vec3(DVec3(box.low) + share * (DVec3(box.high) - DVec3(box.low)));
}

}  // namespace

ZonedCrown::ZonedCrown(const Crown& crown, CrownZone zone)
    : crown_(crown), zone_(zone), bounds_(crown.bounds()), axis_(crown.axis()) {
  if (!bounds_.is_empty()) bounds_.low.y += static_cast<float>(zone.above) * (bounds_.high.y - bounds_.low.y);
}

bool ZonedCrown::contains(Vec3 point) const {
  if (point.y < bounds_.low.y || !crown_.contains(point)) return false;
  if (zone_.outer >= 1) return true;
  const Vec3 axis(axis_.x, point.y, axis_.y);
  return !crown_.contains(axis + (point - axis) / static_cast<float>(1 - zone_.outer));
}

bool is_fillable(const Crown& crown) {
  const Box box = crown.bounds();
  if (box.is_empty()) return false;
  const RandomKey plan(1);
  const RandomKey height(2);
  std::uint64_t hits = 0;
  for (std::uint64_t k = 0; k < kCheckTrials && hits < kCheckHits; ++k) {
    hits += crown.contains(trial(box, plan, height, k)) ? 1 : 0;
  }
  return hits == kCheckHits;
}

CrownSampler::CrownSampler(const Crown& crown, RandomKey key)
    : crown_(crown), box_(crown.bounds()), plan_key_(key.child("plan")), height_key_(key.child("height")) {}

bool CrownSampler::append(std::size_t count, Progress& progress, std::vector<Vec3>& points) {
  while (count > 0) {
    const std::size_t taken = std::min(count, waiting_.size() - given_);
    const auto first = waiting_.begin() + static_cast<std::ptrdiff_t>(given_);
    points.insert(points.end(), first, first + static_cast<std::ptrdiff_t>(taken));
    given_ += taken;
    count -= taken;
    if (count == 0) break;

    // Estimate the number of trials for the remaining points from the trials so far.
    if (box_.is_empty() || (trials_ >= kMaxTrials && accepted_ < trials_ / kTrialsPerHit)) return false;
    const double fill = static_cast<double>(accepted_ + 1) / static_cast<double>(trials_ + 2);
    const double wanted = 1.05 * static_cast<double>(count) / fill;
    make_trials(wanted < kMaxTrials ? static_cast<std::size_t>(wanted) + 1 : kMaxTrials, progress);
  }
  return true;
}

void CrownSampler::make_trials(std::size_t count, Progress& progress) {
  waiting_.clear();
  given_ = 0;
  std::vector<std::vector<Vec3>> found((count + kTrialsPerBlock - 1) / kTrialsPerBlock);
  parallel_for(count, kTrialsPerBlock, [&](std::size_t begin, std::size_t end) {
    progress.check();
    std::vector<Vec3>& accepted = found[begin / kTrialsPerBlock];
    for (std::size_t k = begin; k < end; ++k) {
      const Vec3 point = trial(box_, plan_key_, height_key_, trials_ + k);
      if (crown_.contains(point)) accepted.push_back(point);
    }
  });
  for (const std::vector<Vec3>& block : found) waiting_.insert(waiting_.end(), block.begin(), block.end());
  trials_ += count;
  accepted_ += waiting_.size();
}

double CrownSampler::volume() const {
  if (trials_ == 0 || box_.is_empty()) return 0;
  const DVec3 size(box_.size());
  return size.x * size.y * size.z * (static_cast<double>(accepted_) / static_cast<double>(trials_));
}

}  // namespace meristem
