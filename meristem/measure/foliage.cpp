// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/foliage.h"

#include <algorithm>
#include <vector>

#include "meristem/base/parallel.h"

namespace meristem {
namespace {

constexpr std::size_t kOrgansPerBlock = 1024;

/// Twice the area vectors of a mesh's triangles in its own frame.
std::vector<DVec3> area_vectors(const Mesh& mesh) {
  std::vector<DVec3> vectors;
  vectors.reserve(mesh.triangle_count());
  for (const auto& [a, b, c] : mesh.triangles) {
    const DVec3 corner(mesh.positions[a]);
    vectors.push_back(glm::cross(DVec3(mesh.positions[b]) - corner, DVec3(mesh.positions[c]) - corner));
  }
  return vectors;
}

/// The area of triangles under a frame: area vectors turn and scale by the cofactors of its axes.
double area_in(const Frame& frame, const std::vector<DVec3>& vectors) {
  const DVec3 x(frame.axes[0]);
  const DVec3 y(frame.axes[1]);
  const DVec3 z(frame.axes[2]);
  const DVec3 yz = glm::cross(y, z);
  const DVec3 zx = glm::cross(z, x);
  const DVec3 xy = glm::cross(x, y);
  double twice = 0;
  for (const DVec3& vector : vectors) twice += glm::length(vector.x * yz + vector.y * zx + vector.z * xy);
  return twice / 2;
}

}  // namespace

bool is_leaf(const Plant& plant, const OrganPrototype& prototype) {
  return plant.materials[prototype.material].two_sided;
}

std::vector<double> organ_areas(const Plant& plant, Progress& progress) {
  std::vector<std::vector<DVec3>> vectors;
  for (const OrganPrototype& prototype : plant.prototypes) vectors.push_back(area_vectors(*prototype.mesh));
  progress.begin("measuring", plant.organs.size());
  std::vector<double> areas(plant.organs.size());
  parallel_for(areas.size(), kOrgansPerBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      areas[k] = area_in(plant.organs[k].frame, vectors[plant.organs[k].prototype]);
    }
    progress.advance(end - begin);
  });
  return areas;
}

Foliage measure_foliage(const Plant& plant, Progress& progress) {
  const std::vector<double> areas = organ_areas(plant, progress);
  Foliage foliage;
  for (std::size_t k = 0; k < areas.size(); ++k) {
    if (!is_leaf(plant, plant.prototypes[plant.organs[k].prototype])) continue;
    ++foliage.leaves;
    foliage.area += areas[k];
  }
  return foliage;
}

}  // namespace meristem
