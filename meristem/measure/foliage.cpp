// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/foliage.h"

#include <algorithm>
#include <vector>

#include "meristem/base/parallel.h"

namespace meristem {
namespace {

constexpr std::size_t kOrgansPerBlock = 4096;

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

Foliage measure_foliage(const Plant& plant, Progress& progress) {
  // The triangles of those prototypes that are leaves; others have an empty list.
  std::vector<bool> is_leaf(plant.prototypes.size());
  std::vector<std::vector<DVec3>> vectors(plant.prototypes.size());
  for (std::size_t k = 0; k < plant.prototypes.size(); ++k) {
    is_leaf[k] = plant.materials[plant.prototypes[k].material].two_sided;
    if (is_leaf[k]) vectors[k] = area_vectors(*plant.prototypes[k].mesh);
  }
  progress.begin("measuring", plant.organs.size());
  std::vector<Foliage> blocks((plant.organs.size() + kOrgansPerBlock - 1) / kOrgansPerBlock);
  parallel_for(plant.organs.size(), kOrgansPerBlock, [&](std::size_t begin, std::size_t end) {
    Foliage& block = blocks[begin / kOrgansPerBlock];
    for (std::size_t k = begin; k < end; ++k) {
      const Organ& organ = plant.organs[k];
      if (!is_leaf[organ.prototype]) continue;
      ++block.leaves;
      block.area += area_in(organ.frame, vectors[organ.prototype]);
    }
    progress.advance(end - begin);
  });
  Foliage whole;
  for (const Foliage& block : blocks) {
    whole.leaves += block.leaves;
    whole.area += block.area;
  }
  return whole;
}

}  // namespace meristem
