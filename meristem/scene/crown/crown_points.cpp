// SPDX-License-Identifier: Apache-2.0
// Distributes points over the zones of a crown, each by rejection sampling or as blue noise.
#include "meristem/scene/crown/crown_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/scene/crown/blue_noise.h"

namespace meristem {

namespace {

constexpr std::size_t kBatch = 1U << 16;  // points between two progress reports

[[noreturn]] void throw_empty(const std::string& path, bool is_zone) {
  throw InputError(Diagnostic{
      .message = is_zone ? "the share's part of the crown is empty, or nearly" : "the crown is empty, or nearly",
      .expected = is_zone ? "a smaller 'above' or a larger 'outer'"
                          : "a crown that fills at least a thousandth of the box around it",
      .path = path});
}

}  // namespace

std::vector<std::uint64_t> share_counts(const PointDistribution& distribution) {
  // Round every part down, and give the missing points to the largest remainders (tie: the first).
  const auto total = static_cast<double>(distribution.count);
  std::vector<double> parts;
  double rest = 1;
  for (const PointDistribution::Share& share : distribution.shares) {
    parts.push_back(share.share * total);
    rest -= share.share;
  }
  parts.push_back(rest > 1e-9 ? rest * total : 0);
  std::vector<std::uint64_t> counts;
  std::uint64_t given = 0;
  for (const double part : parts) {
    counts.push_back(std::min(static_cast<std::uint64_t>(part), distribution.count - given));
    given += counts.back();
  }
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return parts[a] - std::floor(parts[a]) > parts[b] - std::floor(parts[b]);
  });
  for (std::size_t k = 0; given < distribution.count; k = (k + 1) % order.size(), ++given) ++counts[order[k]];
  return counts;
}

std::vector<Vec3> place_points(const Crown& crown, const PointDistribution& distribution, RandomKey key,
                               Progress& progress, const std::string& crown_path, const std::string& points_path) {
  const std::vector<std::uint64_t> counts = share_counts(distribution);
  progress.begin("placing points", distribution.count);
  std::vector<Vec3> points;
  points.reserve(distribution.count);
  BlueNoise spaced;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const bool is_zone = k < distribution.shares.size();
    const ZonedCrown zone(crown, is_zone ? distribution.shares[k].zone : CrownZone{});
    CrownSampler sampler(zone, key.child(is_zone ? k + 1 : 0));
    const auto check = [&](bool is_filled) {
      if (!is_filled) throw_empty(is_zone ? fmt::format("{}.shares[{}]", points_path, k) : crown_path, is_zone);
    };
    if (distribution.blue_noise) {
      check(spaced.append(sampler, counts[k], progress, points));
      continue;
    }
    for (std::uint64_t placed = 0; placed < counts[k]; placed += kBatch) {
      const std::size_t batch = std::min<std::uint64_t>(kBatch, counts[k] - placed);
      check(sampler.append(batch, progress, points));
      progress.advance(batch);
    }
  }
  return points;
}

std::vector<Vec3> sample_crown(const Crown& crown, std::uint64_t count, RandomKey key, Progress& progress) {
  return place_points(crown, {.count = count}, key, progress);
}

}  // namespace meristem
