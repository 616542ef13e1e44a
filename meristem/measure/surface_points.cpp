// SPDX-License-Identifier: Apache-2.0
// Maps the unit square to positions on triangles, so that equal areas of the square cover equal areas of the surface. A
// binary search over summed areas finds the triangle. The square root of the remaining share places the position
// between a corner and the opposite edge.
#include "meristem/measure/surface_points.h"

#include <algorithm>
#include <cmath>

namespace meristem {
namespace {

/// Returns twice the area vector of a triangle, along its face's normal.
DVec3 double_area(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const DVec3 corner(mesh.positions[triangle[0]]);
  return glm::cross(DVec3(mesh.positions[triangle[1]]) - corner, DVec3(mesh.positions[triangle[2]]) - corner);
}

}  // namespace

SurfacePoints::SurfacePoints(const Mesh& mesh, std::uint32_t first) : mesh_(mesh) {
  for (std::uint32_t k = first; k < mesh.triangle_count(); ++k) {
    add(k, glm::length(double_area(mesh, mesh.triangles[k])) / 2);
  }
}

SurfacePoints::SurfacePoints(const Mesh& mesh, DVec3 toward) : mesh_(mesh) {
  for (std::uint32_t k = 0; k < mesh.triangle_count(); ++k) {
    const DVec3 area = double_area(mesh, mesh.triangles[k]) / 2.0;
    if (glm::dot(area, toward) > 0) add(k, glm::length(area));
  }
}

void SurfacePoints::add(std::uint32_t triangle, double area) {
  if (!(area > 0)) return;
  area_before_.push_back(this->area() + area);
  triangles_.push_back(triangle);
}

SurfacePoints::Point SurfacePoints::at(double along, double across) const {
  const double reached = along * area();
  const auto found = std::upper_bound(area_before_.begin(), area_before_.end() - 1, reached);
  const auto index = static_cast<std::size_t>(found - area_before_.begin());
  const double before = index == 0 ? 0 : area_before_[index - 1];
  // From the first corner toward the opposite edge, the covered area grows with the square of the distance.
  const double share = std::clamp((reached - before) / (area_before_[index] - before), 0.0, 1.0);
  const double way = std::sqrt(share);
  return {triangles_[index], Vec3(1 - way, way * (1 - across), way * across)};
}

Vec3 SurfacePoints::position(const Point& place) const {
  const auto [a, b, c] = mesh_.triangles[place.triangle];
  return place.weights.x * mesh_.positions[a] + place.weights.y * mesh_.positions[b] +
         place.weights.z * mesh_.positions[c];
}

double fraction(double number) { return number - std::floor(number); }

}  // namespace meristem
