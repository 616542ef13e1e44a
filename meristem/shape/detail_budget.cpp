// SPDX-License-Identifier: Apache-2.0
// Seen from afar, a plant is area, so triangles are worth the area that they cover. A tube counts by its whole surface,
// twice as much as a leaf of equal visible area: leaves that are left out make others larger, tubes that are left out
// do not.
#include "meristem/shape/detail_budget.h"

#include <algorithm>

namespace meristem {
namespace {

/// Parts of a plant that keep one share of their triangles.
struct Part {
  double triangles = 0;
  double area = 0;  // square metres
  std::vector<double>* shares = nullptr;

  double triangles_per_area() const { return triangles / std::max(area, 1e-30); }
};

/// About what all tubes have; a tube of n sides has 2 n triangles per node.
Part tubes_of(const Plant& plant) {
  Part tubes;
  for (const Stem& stem : plant.stems) {
    const Skeleton& skeleton = stem.skeleton;
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      const NodeIndex parent = skeleton.parent[node];
      if (parent == kNoNode) continue;
      const Surface& surface =
          stem.parts[stem.part_of_axis.empty() ? 0 : stem.part_of_axis[skeleton.axis[node]]].surface;
      if (surface.style == Surface::Style::blend) continue;
      const double length = glm::length(skeleton.position[node] - skeleton.position[parent]);
      tubes.triangles += 2.0 * surface.sides;
      tubes.area += 2 * kPi * length * skeleton.radius[node];
    }
  }
  return tubes;
}

/// Sets what each part keeps, so that all together have `wanted` triangles: as many per area, and none more than it
/// has.
void divide(std::vector<Part>& parts, double wanted, int level) {
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.triangles_per_area() < b.triangles_per_area(); });
  double area = 0;
  for (const Part& part : parts) area += part.area;
  for (const Part& part : parts) {
    const double most = area > 0 ? wanted * part.area / area : wanted;
    const double kept = std::min(part.triangles, most);
    // A level shows nothing that the one before does not.
    double& share = (*part.shares)[static_cast<std::size_t>(level)];
    share =
        std::min((*part.shares)[static_cast<std::size_t>(level) - 1], part.triangles > 0 ? kept / part.triangles : 1);
    wanted -= kept;
    area -= part.area;
  }
}

}  // namespace

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 corner = mesh.positions[a];
    area += 0.5 * glm::length(glm::cross(mesh.positions[b] - corner, mesh.positions[c] - corner));
  }
  return area;
}

DetailBudget::DetailBudget(const Plant& plant, const Detail& detail) {
  const auto levels = static_cast<std::size_t>(detail.level) + 1;
  tubes_.assign(levels, 1);
  std::vector<Part> of_prototypes(plant.prototypes.size());
  for (std::size_t k = 0; k < of_prototypes.size(); ++k) {
    organs_.try_emplace(plant.prototypes[k].component, levels, 1.0);
  }
  if (detail.level == 0) return;
  for (const Organ& organ : plant.organs) {
    Part& part = of_prototypes[organ.prototype];
    part.triangles += 1;
    part.area += glm::length(glm::cross(organ.frame.axes[0], organ.frame.axes[1]));  // of a blade's plane
  }
  std::map<std::string_view, Part> of_components;
  for (std::size_t k = 0; k < of_prototypes.size(); ++k) {
    const Mesh& mesh = *plant.prototypes[k].mesh;
    Part& part = of_components[plant.prototypes[k].component];
    part.triangles += of_prototypes[k].triangles * static_cast<double>(mesh.triangle_count());
    part.area += of_prototypes[k].area * area_of(mesh);
  }
  std::vector<Part> parts;
  parts.push_back(tubes_of(plant));
  parts.back().shares = &tubes_;
  for (auto& [component, part] : of_components) {
    parts.push_back(part);
    parts.back().shares = &organs_.at(component);
  }
  double triangles = 0;
  for (const Part& part : parts) triangles += part.triangles;
  for (int level = 1; level <= detail.level; ++level) divide(parts, detail.kept(level) * triangles, level);
}

}  // namespace meristem
