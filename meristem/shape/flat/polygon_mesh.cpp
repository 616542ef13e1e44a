// SPDX-License-Identifier: Apache-2.0
// Triangulates a polygon in its best fitting plane. Large polygons are first cut into bands, because it is slow to cut
// off the best ear among many.
#include "meristem/shape/flat/polygon_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/shape/flat/cut_polygon.h"
#include "meristem/shape/flat/flat_ring.h"

namespace meristem {

namespace {

constexpr std::size_t kCornersOfBand = 16;
constexpr std::size_t kFewCorners = 64;  // maximum number of corners without bands
constexpr float kSameCorner = 1e-6F;     // share of the polygon's extent
constexpr double kNoArea = 1e-9;         // share of the polygon's squared extent
constexpr double kLineTolerance = 1e-6;  // share of the polygon's extent

/// Returns the corners without repetitions.
std::vector<Vec3> distinct(std::span<const Vec3> corners, float extent) {
  std::vector<Vec3> kept;
  const auto is_new = [&](Vec3 corner, Vec3 other) { return glm::length(corner - other) > kSameCorner * extent; };
  for (const Vec3 corner : corners) {
    if (kept.empty() || is_new(corner, kept.back())) kept.push_back(corner);
  }
  while (kept.size() > 1 && !is_new(kept.back(), kept.front())) kept.pop_back();
  return kept;
}

/// Returns heights that divide the corners into bands of few corners.
std::vector<double> band_lines(const std::vector<glm::dvec2>& flat, double tolerance) {
  std::vector<double> heights;
  for (const glm::dvec2 corner : flat) heights.push_back(corner.y);
  std::ranges::sort(heights);
  std::vector<double> lines;
  for (std::size_t k = kCornersOfBand; k + 1 < heights.size(); k += kCornersOfBand) {
    const double line = 0.5 * (heights[k] + heights[k + 1]);
    if (lines.empty() || line > lines.back() + 4 * tolerance) lines.push_back(line);
  }
  return lines;
}

}  // namespace

Mesh make_polygon(std::span<const Vec3> given) {
  Mesh mesh;
  if (given.size() < 3) return mesh;
  Vec3 min = given[0];
  Vec3 max = given[0];
  for (const Vec3 corner : given) {
    min = glm::min(min, corner);
    max = glm::max(max, corner);
  }
  const float extent = glm::length(max - min);
  std::vector<Vec3> corners = distinct(given, extent);
  if (corners.size() < 3) return mesh;
  DVec3 area = area_vector(corners);
  if (glm::length(area) < kNoArea * extent * extent) return mesh;
  if (area.z < 0) {
    std::ranges::reverse(corners);
    area = -area;
  }

  const DVec3 normal = glm::normalize(area);
  const Frame plane =
      frame_along(corners[0], normalized_or(Vec3(DVec3(0, 1, 0) - normal.y * normal), {1, 0, 0}), Vec3(normal));
  std::vector<glm::dvec2> flat;
  std::map<std::pair<double, double>, Vec3> place;
  for (const Vec3 corner : corners) {
    const DVec3 from_origin(corner - plane.origin);
    flat.emplace_back(glm::dot(from_origin, DVec3(plane.right())), glm::dot(from_origin, DVec3(plane.heading())));
    place.emplace(std::pair(flat.back().x, flat.back().y), corner);
  }
  glm::dvec2 low = flat[0];
  glm::dvec2 high = flat[0];
  for (const glm::dvec2 corner : flat) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }

  const double tolerance = kLineTolerance * extent;
  CutLines lines{.row_tolerance = tolerance, .column_tolerance = tolerance};
  if (flat.size() > kFewCorners) lines.rows = band_lines(flat, tolerance);
  std::map<std::pair<double, double>, std::uint32_t> vertex;
  const auto vertex_at = [&](glm::dvec2 corner) {
    const auto [found, is_new] =
        vertex.try_emplace(std::pair(corner.x, corner.y), static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) {
      const auto own = place.find(found->first);
      mesh.positions.push_back(own != place.end() ? own->second : plane.point({corner.x, corner.y, 0}));
      mesh.normals.emplace_back(normal);
      mesh.uvs.emplace_back((corner - low) / (high - low));
    }
    return found->second;
  };
  for (const FlatTriangle& triangle : cut_polygon(flat, lines)) {
    mesh.triangles.push_back({vertex_at(triangle[0]), vertex_at(triangle[1]), vertex_at(triangle[2])});
  }
  return mesh;
}

}  // namespace meristem
