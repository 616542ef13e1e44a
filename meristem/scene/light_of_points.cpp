// SPDX-License-Identifier: Apache-2.0
// Computes the light of points that shade each other. For each light, the points are projected onto a plane at right
// angles to the light and sorted by distance, nearest to the light first. Each point then counts earlier points near
// it, in a grid of counters.
#include "meristem/scene/light_of_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"

namespace meristem {
namespace {

constexpr int kCellsPerRadius = 6;
constexpr int kBrickBits = 3;
constexpr int kBrickSide = 1 << kBrickBits;
constexpr std::size_t kLightsAtOnce = 16;
constexpr std::size_t kPointsPerBlock = 64;
constexpr std::uint32_t kPointsPerCheck = 1024;

/// The half widths of the rows of a disc, from its middle row outward.
using HalfWidths = std::array<int, kCellsPerRadius + 1>;

/// Counters of cells in a plane, stored in sparse bricks.
class CellCounts {
 public:
  void add(std::int64_t x, std::int64_t y) { ++bricks_[key(x >> kBrickBits, y >> kBrickBits)][place(x, y)]; }

  /// Returns the sum over a disc whose rows extend `half_widths[|dy|]` cells to both sides of the centre.
  std::uint64_t in_disc(std::int64_t x, std::int64_t y, const HalfWidths& half_widths) const {
    // The disc overlaps at most nine bricks.
    std::uint64_t count = 0;
    for (std::int64_t by = (y - kCellsPerRadius) >> kBrickBits; by <= (y + kCellsPerRadius) >> kBrickBits; ++by) {
      for (std::int64_t bx = (x - kCellsPerRadius) >> kBrickBits; bx <= (x + kCellsPerRadius) >> kBrickBits; ++bx) {
        const auto brick = bricks_.find(key(bx, by));
        if (brick != bricks_.end())
          count += in_brick(brick->second, x - bx * kBrickSide, y - by * kBrickSide, half_widths);
      }
    }
    return count;
  }

 private:
  using Brick = std::array<std::uint32_t, std::size_t{kBrickSide} * kBrickSide>;

  /// Returns the sum over the part of a disc in this brick. (x, y) is the disc's centre relative to the brick's corner.
  static std::uint64_t in_brick(const Brick& brick, std::int64_t x, std::int64_t y, const HalfWidths& half_widths) {
    std::uint64_t count = 0;
    const std::int64_t last = std::min<std::int64_t>(y + kCellsPerRadius, kBrickSide - 1);
    for (std::int64_t row = std::max<std::int64_t>(y - kCellsPerRadius, 0); row <= last; ++row) {
      const int half = half_widths[static_cast<std::size_t>(std::abs(row - y))];
      const std::int64_t right = std::min<std::int64_t>(x + half, kBrickSide - 1);
      for (std::int64_t cell = std::max<std::int64_t>(x - half, 0); cell <= right; ++cell)
        count += brick[place(cell, row)];
    }
    return count;
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32 ^ (static_cast<std::uint64_t>(y) & 0xFFFFFFFF);
  }
  static std::size_t place(std::int64_t x, std::int64_t y) {
    return static_cast<std::size_t>((y & (kBrickSide - 1)) * kBrickSide + (x & (kBrickSide - 1)));
  }

  // Iteration order does not matter, because the map is only used for lookups.
  std::unordered_map<std::uint64_t, Brick> bricks_;
};

HalfWidths disc_half_widths() {
  HalfWidths half_widths{};
  for (int dy = 0; dy <= kCellsPerRadius; ++dy) {
    half_widths[static_cast<std::size_t>(dy)] =
        static_cast<int>(std::floor(std::sqrt(kCellsPerRadius * kCellsPerRadius - dy * dy)));
  }
  return half_widths;
}

/// Returns, for each point, how many other points lie between the point and a directional light toward `toward`, within
/// `radius` of the ray.
std::vector<std::uint32_t> count_before(const std::vector<Vec3>& points, Vec3 toward, double radius,
                                        const Progress& progress) {
  const auto half_widths = disc_half_widths();
  const Frame frame = frame_along(Vec3(0), toward, any_perpendicular(toward));
  const DVec3 right(frame.axes[0]);
  const DVec3 forward(frame.axes[2]);
  const DVec3 way(toward);
  const DVec3 origin(points[0]);
  struct Seen {
    double depth;  // position along the direction to the light
    std::int64_t x, y;
    std::uint32_t point;
  };
  std::vector<Seen> seen;
  seen.reserve(points.size());
  const double per_metre = kCellsPerRadius / radius;
  for (const Vec3 point : points) {
    const DVec3 offset = DVec3(point) - origin;
    seen.push_back({glm::dot(offset, way), static_cast<std::int64_t>(std::floor(glm::dot(offset, right) * per_metre)),
                    static_cast<std::int64_t>(std::floor(glm::dot(offset, forward) * per_metre)),
                    static_cast<std::uint32_t>(seen.size())});
  }
  progress.check();
  std::sort(seen.begin(), seen.end(),
            [](const Seen& a, const Seen& b) { return a.depth != b.depth ? a.depth > b.depth : a.point < b.point; });
  std::vector<std::uint32_t> counts(points.size());
  CellCounts cells;
  for (const Seen& one : seen) {
    if (one.point % kPointsPerCheck == 0) progress.check();
    counts[one.point] = static_cast<std::uint32_t>(cells.in_disc(one.x, one.y, half_widths));
    cells.add(one.x, one.y);
  }
  return counts;
}

}  // namespace

std::vector<double> light_of_points(const std::vector<Vec3>& points, const Scene& scene, double radius, double k,
                                    const Progress& progress) {
  std::vector<double> light(points.size());
  if (points.empty()) return light;
  const auto is_shaded = [&](Vec3 point, const LightRay& ray) {
    return scene.obstacles.block(point, ray.toward, ray.distance);
  };
  std::vector<DirectionalLight> lights = scene.light.sun;
  lights.insert(lights.end(), scene.light.sky.begin(), scene.light.sky.end());
  std::vector<std::vector<std::uint32_t>> before(kLightsAtOnce);
  for (std::size_t first = 0; first < lights.size(); first += kLightsAtOnce) {
    const std::size_t count = std::min(kLightsAtOnce, lights.size() - first);
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        before[f] = count_before(points, lights[first + f].toward, radius, progress);
      }
    });
    parallel_for(points.size(), kPointsPerBlock, [&](std::size_t begin, std::size_t end) {
      progress.check();
      for (std::size_t p = begin; p < end; ++p) {
        for (std::size_t f = 0; f < count; ++f) {
          const DirectionalLight& one = lights[first + f];
          if (!is_shaded(points[p], {.toward = one.toward})) light[p] += one.strength * math::exp(-k * before[f][p]);
        }
      }
    });
  }
  parallel_for(points.size(), kPointsPerBlock, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t p = begin; p < end; ++p) {
      for (const Lamp& lamp : scene.light.lamps) {
        const LightRay ray = Light::ray_to(lamp, points[p]);
        if (!is_shaded(points[p], ray)) light[p] += ray.strength;
      }
    }
  });
  return light;
}

std::vector<std::uint32_t> brightest(std::span<const double> light, double share) {
  struct Ranked {
    double light;
    std::uint64_t lot;
    std::uint32_t point;
  };
  std::vector<Ranked> ranked;
  for (const double one : light) {
    const auto point = static_cast<std::uint32_t>(ranked.size());
    ranked.push_back({one, RandomKey().child(point).bits(), point});
  }
  std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
    return std::tie(a.light, a.lot, a.point) < std::tie(b.light, b.lot, b.point);
  });
  const auto removed = static_cast<std::size_t>(std::floor(share * static_cast<double>(light.size())));
  std::vector<std::uint32_t> left;
  for (std::size_t k = removed; k < ranked.size(); ++k) left.push_back(ranked[k].point);
  std::sort(left.begin(), left.end());
  return left;
}

}  // namespace meristem
