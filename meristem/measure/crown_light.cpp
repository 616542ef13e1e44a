// SPDX-License-Identifier: Apache-2.0
// In:  a crown's convex hull, the sun's positions, obstacles. Out: the share of the hull that each position lights.
//
// A convex body shades itself exactly where it faces away, so the area that faces the sun is a sum over triangles. Rays
// sample only the shadow of the obstacles. They start at positions that are spread evenly over the hull: by area along
// the triangles, and by steps of the golden ratio across them.
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, equation 5.5. The source counts random positions on the whole hull and also tests them against the hull.
#include "meristem/measure/crown_light.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "meristem/base/parallel.h"
#include "meristem/measure/convex_hull.h"
#include "meristem/measure/surface_points.h"

namespace meristem {
namespace {

constexpr std::size_t kCrownRaysPerBlock = 2048;

/// Returns the share of the positions' area that a directional light reaches. Each position of the sun has its own
/// `turn`, so that suns with few rays use different positions.
double unshaded_share(const SurfacePoints& places, Vec3 toward, const Obstacles& obstacles, std::uint64_t rays,
                      std::size_t turn, const Progress* progress) {
  const double first = fraction(0.5 + static_cast<double>(turn) * kSquareSteps[0]);
  const double start = fraction(static_cast<double>(turn) * kSquareSteps[1]);
  std::vector<std::uint64_t> unshaded((rays + kCrownRaysPerBlock - 1) / kCrownRaysPerBlock, 0);
  parallel_for(rays, kCrownRaysPerBlock, [&](std::size_t begin, std::size_t end) {
    if (progress != nullptr) progress->check();
    for (std::size_t k = begin; k < end; ++k) {
      const double along = (static_cast<double>(k) + first) / static_cast<double>(rays);
      const double across = fraction(start + static_cast<double>(k) * kGoldenStep);
      const Vec3 position = places.position(places.at(along, across));
      const bool is_shaded = obstacles.block(position, toward, std::numeric_limits<double>::infinity());
      if (!is_shaded) ++unshaded[begin / kCrownRaysPerBlock];
    }
  });
  const std::uint64_t sum = std::accumulate(unshaded.begin(), unshaded.end(), std::uint64_t{0});
  return static_cast<double>(sum) / static_cast<double>(rays);
}

}  // namespace

CrownLight measure_crown_light(const Mesh& hull, const Scene& scene, std::uint64_t rays, const Progress* progress) {
  CrownLight light;
  const std::vector<DirectionalLight>& sun = scene.light.sun;
  const double area = surface_area_of(hull);
  light.lit_shares.resize(sun.size(), 0);
  if (sun.empty() || !(area > 0)) return light;
  const std::uint64_t rays_each = std::max<std::uint64_t>(rays / sun.size(), 1);
  parallel_for(sun.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (progress != nullptr) progress->check();
      const SurfacePoints facing(hull, DVec3(sun[k].toward));
      double share = facing.area() / area;
      if (share > 0 && !scene.obstacles.empty()) {
        share *= unshaded_share(facing, sun[k].toward, scene.obstacles, rays_each, k, progress);
      }
      light.lit_shares[k] = share;
    }
  });
  const double sum = std::accumulate(light.lit_shares.begin(), light.lit_shares.end(), 0.0);
  light.lit_share = sum / static_cast<double>(sun.size());
  return light;
}

}  // namespace meristem
