// SPDX-License-Identifier: Apache-2.0
// Flattens polygons in space and triangulates their faces. If all corners are visible from the middle, the face is a
// fan around it. Otherwise the polygon is cut into triangles of its corners (cut_polygon.h).
#include "meristem/shape/flat/flat_ring.h"

#include <limits>
#include <map>
#include <utility>

#include "meristem/base/frame.h"
#include "meristem/shape/flat/cut_polygon.h"

namespace meristem {

namespace {

constexpr double kMinCorner = 1e-6;  // share of the unit square: minimum area of the triangles around the middle

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace

double extent_of(std::span<const Vec3> points) {
  Box box;
  for (const Vec3 point : points) box.add(point);
  return glm::length(DVec3(box.size()));
}

DVec3 area_vector(std::span<const Vec3> corners) {
  DVec3 sum(0);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    sum += glm::cross(DVec3(corners[k] - corners[0]), DVec3(corners[(k + 1) % corners.size()] - corners[0]));
  }
  return sum;
}

std::vector<glm::dvec2> flattened(std::span<const Vec3> corners, DVec3 area) {
  const DVec3 normal = glm::normalize(area);
  const Vec3 north = normalized_or(Vec3(DVec3(0, 0, -1) + normal.z * normal), {1, 0, 0});
  const Frame plane = frame_along(corners[0], north, Vec3(normal));
  std::vector<glm::dvec2> flat;
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high = -low;
  for (const Vec3 corner : corners) {
    const DVec3 from_origin(corner - plane.origin);
    flat.emplace_back(glm::dot(from_origin, DVec3(plane.right())), glm::dot(from_origin, DVec3(plane.heading())));
    low = glm::min(low, flat.back());
    high = glm::max(high, flat.back());
  }
  for (glm::dvec2& corner : flat) corner = (corner - low) / (high - low);
  return flat;
}

RingFace ring_face(const std::vector<glm::dvec2>& corners) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  RingFace face;
  if (count == 3) {
    face.triangles.push_back({0, 1, 2});
    return face;
  }
  glm::dvec2 middle(0);
  for (const glm::dvec2 corner : corners) middle += corner / static_cast<double>(count);
  face.has_middle = true;
  for (std::uint32_t k = 0; k < count && face.has_middle; ++k) {
    const std::uint32_t next = (k + 1) % count;
    face.has_middle = cross(corners[k] - middle, corners[next] - middle) > kMinCorner;
    face.triangles.push_back({k, next, count});
  }
  if (face.has_middle) return face;
  face.triangles.clear();
  std::map<std::pair<double, double>, std::uint32_t> number;
  for (std::uint32_t k = 0; k < count; ++k) number.try_emplace({corners[k].x, corners[k].y}, k);
  for (const auto& [a, b, c] : cut_polygon(corners, {})) {
    face.triangles.push_back({number.at({a.x, a.y}), number.at({b.x, b.y}), number.at({c.x, c.y})});
  }
  return face;
}

}  // namespace meristem
