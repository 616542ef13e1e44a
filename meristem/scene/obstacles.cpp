// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/obstacles.h"

#include <limits>
#include <stdexcept>
#include <utility>

namespace meristem {

namespace {

/// The distance along a ray to a triangle (Moeller and Trumbore), if it is met before `within`.
std::optional<double> distance_to(DVec3 origin, DVec3 direction, DVec3 a, DVec3 b, DVec3 c, double within) {
  const DVec3 u = b - a;
  const DVec3 v = c - a;
  const DVec3 p = glm::cross(direction, v);
  const double determinant = glm::dot(u, p);
  if (determinant == 0) return std::nullopt;
  const DVec3 w = origin - a;
  const double along_u = glm::dot(w, p) / determinant;
  if (!(along_u >= 0 && along_u <= 1)) return std::nullopt;
  const DVec3 q = glm::cross(w, u);
  const double along_v = glm::dot(direction, q) / determinant;
  if (!(along_v >= 0 && along_u + along_v <= 1)) return std::nullopt;
  const double distance = glm::dot(v, q) / determinant;
  if (!(distance >= 0 && distance < within)) return std::nullopt;
  return distance;
}

}  // namespace

struct Obstacles::Content {
  std::vector<Obstacle> bodies;
  std::vector<ClosedMesh> insides;
  std::vector<Vec3> centroids;
  std::vector<Box> boxes;
  Box bounds;
};

TriangleMesh box_mesh(DVec3 low, DVec3 high) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.positions.push_back(
        {(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y, (k & 4) != 0 ? high.z : low.z});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

Obstacles::Obstacles() : content_(std::make_shared<const Content>()) {}

Obstacles::Obstacles(std::vector<Obstacle> bodies) {
  auto content = std::make_shared<Content>();
  content->bodies = std::move(bodies);
  for (const Obstacle& body : content->bodies) {
    content->insides.emplace_back(body.mesh);
    Box box;
    double volume = 0;
    DVec3 sum(0);
    for (const auto& triangle : body.mesh.triangles) {
      const DVec3 a = body.mesh.positions[triangle[0]];
      const DVec3 b = body.mesh.positions[triangle[1]];
      const DVec3 c = body.mesh.positions[triangle[2]];
      const double part = glm::dot(a, glm::cross(b, c));
      volume += part;
      sum += part * (a + b + c) / 4.0;
    }
    for (const DVec3 position : body.mesh.positions) box.add(Vec3(position));
    content->boxes.push_back(box);
    content->bounds.add(box);
    const Vec3 centroid = volume != 0 ? Vec3(sum / volume) : box.centre();
    content->centroids.emplace_back(centroid.x, 0, centroid.z);
  }
  content_ = std::move(content);
}

const std::vector<Obstacle>& Obstacles::bodies() const { return content_->bodies; }
Box Obstacles::bounds() const { return content_->bounds; }

bool Obstacles::contain(Vec3 place) const {
  for (const ClosedMesh& inside : content_->insides) {
    if (inside.contains(DVec3(place))) return true;
  }
  return false;
}

bool Obstacles::cross(Vec3 from, Vec3 to) const {
  const DVec3 way = DVec3(to) - DVec3(from);
  const double length = glm::length(way);
  return length > 0 && first_hit(from, Vec3(way / length), length).has_value();
}

std::optional<Obstacles::Hit> Obstacles::first_hit(Vec3 origin, Vec3 direction, double within) const {
  std::optional<Hit> first;
  for (std::size_t k = 0; k < bodies().size(); ++k) {
    const TriangleMesh& mesh = bodies()[k].mesh;
    for (const auto& triangle : mesh.triangles) {
      const auto distance =
          distance_to(DVec3(origin), DVec3(direction), mesh.positions[triangle[0]], mesh.positions[triangle[1]],
                      mesh.positions[triangle[2]], first ? first->distance : within);
      if (distance) first = Hit{*distance, k};
    }
  }
  return first;
}

Vec3 Obstacles::ground_centroid(std::size_t obstacle) const { return content_->centroids[obstacle]; }

}  // namespace meristem
