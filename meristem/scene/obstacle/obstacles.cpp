// SPDX-License-Identifier: Apache-2.0
// Queries about all obstacles: a box tree and exact winding numbers decide what is inside, and an Embree tree finds
// surfaces on rays.
#include "meristem/scene/obstacle/obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/scene/obstacle/box_tree.h"
#include "meristem/scene/obstacle/obstacle_tree.h"

namespace meristem {

namespace {

/// Returns the smallest float box that contains all positions.
Box box_around(const TriangleMesh& mesh) {
  Box box;
  for (const DVec3 position : mesh.positions) {
    const Vec3 rounded(position);
    box.add(rounded);
    for (int k = 0; k < 3; ++k) {
      constexpr float kInfinity = std::numeric_limits<float>::infinity();
      if (rounded[k] > position[k]) box.low[k] = std::min(box.low[k], std::nextafter(rounded[k], -kInfinity));
      if (rounded[k] < position[k]) box.high[k] = std::max(box.high[k], std::nextafter(rounded[k], kInfinity));
    }
  }
  return box;
}

bool overlap(const Box& a, const Box& b) {
  return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

void check_mesh(const TriangleMesh& mesh) {
  for (const DVec3 position : mesh.positions) {
    const Vec3 rounded(position);
    if (!std::isfinite(rounded.x + rounded.y + rounded.z)) {
      throw std::invalid_argument("obstacles: a position is not finite");
    }
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      if (vertex >= mesh.positions.size()) throw std::invalid_argument("obstacles: an index is out of range");
    }
  }
}

/// Returns the mesh with cyclically permuted axes: axis `first` becomes x.
TriangleMesh renamed(const TriangleMesh& mesh, int first) {
  TriangleMesh result{{}, mesh.triangles};
  result.positions.reserve(mesh.positions.size());
  for (const DVec3 position : mesh.positions) {
    result.positions.emplace_back(position[first], position[(first + 1) % 3], position[(first + 2) % 3]);
  }
  return result;
}

/// Returns the centroid of a body's volume. A broken body has no volume, so its surface is used.
DVec3 centroid_of(const Obstacle& body, DVec3 middle) {
  double total = 0;
  DVec3 sum(0);
  for (const auto& [p, q, r] : body.mesh.triangles) {
    const DVec3 a = body.mesh.positions[p] - middle;
    const DVec3 b = body.mesh.positions[q] - middle;
    const DVec3 c = body.mesh.positions[r] - middle;
    if (body.is_broken) {
      const double area = glm::length(glm::cross(b - a, c - a));
      total += area;
      sum += area * (a + b + c) / 3.0;
    } else {
      const double volume = glm::dot(a, glm::cross(b, c));
      total += volume;
      sum += volume * (a + b + c) / 4.0;
    }
  }
  return total != 0 ? middle + sum / total : middle;
}

/// Tests whether a position is inside one body.
class Inside {
 public:
  explicit Inside(const Obstacle& body) : box_(box_around(body.mesh)) {
    views_.emplace_back(body.mesh);
    if (!body.is_broken) return;
    for (int axis = 1; axis < 3; ++axis) views_.emplace_back(renamed(body.mesh, axis));
  }

  const Box& box() const { return box_; }

  /// Returns true if the body contains a position in its box.
  bool contains(Vec3 point) const {
    const DVec3 at(point);
    if (views_.size() == 1) return views_[0].contains(at);
    int votes = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const DVec3 seen(at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3]);
      votes += views_[static_cast<std::size_t>(axis)].winding_number(seen) % 2 != 0 ? 1 : 0;
    }
    return votes >= 2;
  }

 private:
  Box box_;
  std::vector<ClosedMesh> views_;  // one view, or three with permuted axes for a broken body
};

}  // namespace

struct Obstacles::Content {
  std::vector<Obstacle> bodies;
  std::vector<Inside> insides;
  std::vector<Vec3> centroids;
  Box bounds;
  BoxTree boxes;
  std::unique_ptr<const ObstacleTree> tree;
};

TriangleMesh box_mesh(DVec3 low, DVec3 high) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.positions.emplace_back((k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                                (k & 4) != 0 ? high.z : low.z);
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

Obstacles::Obstacles() : content_(std::make_shared<const Content>()) {}

Obstacles::Obstacles(std::vector<Obstacle> bodies) {
  auto content = std::make_shared<Content>();
  content->bodies = std::move(bodies);
  std::vector<const TriangleMesh*> meshes;
  std::vector<Box> boxes;
  for (const Obstacle& body : content->bodies) {
    check_mesh(body.mesh);
    meshes.push_back(&body.mesh);
    const Box box = content->insides.emplace_back(body).box();
    boxes.push_back(box);
    content->bounds.add(box);
    const DVec3 centroid = box.is_empty() ? DVec3(0) : centroid_of(body, DVec3(box.centre()));
    content->centroids.emplace_back(centroid.x, 0, centroid.z);
  }
  content->boxes = BoxTree(boxes);
  if (!meshes.empty()) content->tree = std::make_unique<const ObstacleTree>(meshes);
  content_ = std::move(content);
}

const std::vector<Obstacle>& Obstacles::bodies() const { return content_->bodies; }
Box Obstacles::bounds() const { return content_->bounds; }

bool Obstacles::contain(Vec3 point) const {
  return content_->boxes.any_around(point, [&](std::uint32_t k) { return content_->insides[k].contains(point); });
}

bool Obstacles::cross(Vec3 from, Vec3 to) const {
  if (empty() || from == to) return false;
  Box way;
  way.add(from);
  way.add(to);
  if (!overlap(way, content_->bounds)) return false;
  if (content_->tree->is_met(DVec3(from), DVec3(to) - DVec3(from), 1)) return true;
  // Ways too short for the ray test still cross a surface if only one end is inside.
  return contain(from) != contain(to);
}

std::optional<Obstacles::Hit> Obstacles::first_hit(Vec3 origin, Vec3 direction, double within) const {
  if (empty()) return std::nullopt;
  const auto hit = content_->tree->first_hit(DVec3(origin), DVec3(direction), within);
  return hit ? std::optional(Hit{hit->distance, hit->body}) : std::nullopt;
}

bool Obstacles::block(Vec3 origin, Vec3 direction, double within) const {
  return !empty() && content_->tree->is_met(DVec3(origin), DVec3(direction), within);
}

std::optional<Vec3> Obstacles::away_from_surface(Vec3 position) const {
  if (empty()) return std::nullopt;
  const auto near = content_->tree->nearest(DVec3(position));
  if (!near) return std::nullopt;
  constexpr double kOnSurface = 1e-6;  // metres, about the resolution of floats
  const DVec3 way = DVec3(position) - near->position;
  const double distance = glm::length(way);
  if (distance < kOnSurface) {
    return near->normal != DVec3(0) ? std::optional(Vec3(near->normal)) : std::nullopt;
  }
  return Vec3((contain(position) ? -1.0 : 1.0) / distance * way);
}

double Obstacles::distance_to_surface(Vec3 position) const {
  const auto near = empty() ? std::nullopt : content_->tree->nearest(DVec3(position));
  return near ? glm::distance(near->position, DVec3(position)) : std::numeric_limits<double>::infinity();
}

Vec3 Obstacles::ground_centroid(std::size_t obstacle) const { return content_->centroids[obstacle]; }

std::vector<std::uint8_t> inside_of(const Obstacles& obstacles, std::span<const Vec3> places,
                                    const Progress& progress) {
  constexpr std::size_t kPlacesPerBlock = 256;
  std::vector<std::uint8_t> is_inside(places.size());
  if (obstacles.empty()) return is_inside;
  parallel_for(places.size(), kPlacesPerBlock, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t k = begin; k < end; ++k) is_inside[k] = obstacles.contain(places[k]) ? 1 : 0;
  });
  return is_inside;
}

}  // namespace meristem
