// SPDX-License-Identifier: Apache-2.0
// Chooses a side from which obstacles hide little of the plants. Rays from some vertices of the plants to the camera's
// position measure the visible share. Only obstacles count, since plants that hide each other belong to the picture.
#include "meristem/output/picture/free_side.h"

#include <algorithm>
#include <array>
#include <vector>

#include "meristem/base/math.h"
#include "meristem/output/picture/camera.h"
#include "meristem/output/picture/obstacle_meshes.h"
#include "meristem/shape/rays/ray_scene.h"

namespace meristem {

namespace {

constexpr std::size_t kSamples = 500;  // number of vertices of the plants; more give a finer share and take longer
constexpr double kEnough = 0.5;        // share of the plants that must be visible
constexpr int kSides = 8;
constexpr std::array<double, 2> kHigherAltitudes{0.5, 1.2};  // radians, above walls that stand all around

/// Returns vertices that are spread evenly over the instances of all meshes.
std::vector<Vec3> sample_points(const MeshScene& plants) {
  std::size_t vertices = 0;
  for (const MeshInstances& part : plants.meshes) vertices += part.count() * part.mesh->vertex_count();
  const std::size_t count = std::min(kSamples, vertices);
  std::vector<Vec3> points;
  points.reserve(count);
  std::size_t before = 0;  // vertices of earlier parts
  for (const MeshInstances& part : plants.meshes) {
    const std::size_t each = part.mesh->vertex_count();
    const std::size_t end = before + part.count() * each;
    while (points.size() < count) {
      const auto share = (static_cast<double>(points.size()) + 0.5) / static_cast<double>(count);
      const auto vertex = static_cast<std::size_t>(share * static_cast<double>(vertices));
      if (vertex >= end) break;
      points.push_back(part.frame((vertex - before) / each).point(part.mesh->positions[(vertex - before) % each]));
    }
    before = end;
  }
  return points;
}

bool has_own_side(const CameraView& view) {
  const CameraView usual;
  return view.position || view.target || view.azimuth != usual.azimuth || view.altitude != usual.altitude;
}

/// Returns the sides to try: the default side first, then its neighbours by distance.
std::vector<CameraView> sides(const CameraView& view) {
  std::vector<double> altitudes{view.altitude};
  altitudes.insert(altitudes.end(), kHigherAltitudes.begin(), kHigherAltitudes.end());
  std::vector<CameraView> all;
  for (const double altitude : altitudes) {
    for (int k = 0; k < kSides; ++k) {
      const int step = k % 2 == 0 ? -k / 2 : (k + 1) / 2;  // 0, 1, -1, 2, -2, ...
      CameraView side = view;
      side.azimuth = view.azimuth + step * 2 * kPi / kSides;
      side.altitude = altitude;
      all.push_back(side);
    }
  }
  return all;
}

/// Returns the share of the points that are visible from a position.
double seen_share(const std::vector<Vec3>& points, const RayScene& obstacles, Vec3 position) {
  std::size_t seen = 0;
  for (const Vec3 point : points) {
    const Vec3 way = position - point;
    const float length = glm::length(way);
    const float start = RayScene::clearance(point);
    if (!(length > start)) continue;
    const Vec3 direction = way / length;
    seen += obstacles.is_blocked({point + start * direction, direction}, length - start) ? 0U : 1U;
  }
  return static_cast<double>(seen) / static_cast<double>(points.size());
}

}  // namespace

CameraView view_past_obstacles(const MeshScene& plants, const Obstacles& obstacles, CameraView view, double aspect,
                               const Progress& progress) {
  if (has_own_side(view) || !has_visible(obstacles)) return view;
  const std::vector<Vec3> points = sample_points(plants);
  if (points.empty()) return view;
  Progress part(&progress);
  const MeshScene bodies = obstacle_meshes(obstacles, part);
  const RayScene rays(bodies, part);
  const std::vector<CameraView> candidates = sides(view);
  double best_share = -1;
  for (const CameraView& candidate : candidates) {
    part.check();
    const double share = seen_share(points, rays, place_camera(plants, candidate, aspect).position());
    if (share > best_share) {
      best_share = share;
      view = candidate;
    }
    if (share >= kEnough) break;
  }
  return view;
}

}  // namespace meristem
