// SPDX-License-Identifier: Apache-2.0
// Divides triangles among tubes and organs in proportion to area, since a plant far away is seen as area. A tube counts
// with its whole surface, twice as much as a leaf of equal visible area: removed leaves make others larger, but removed
// tubes do not.
#include "meristem/shape/detail/detail_budget.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace meristem {
namespace {

double triangle_area(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec3 corner = mesh.positions[a];
  return 0.5 * glm::length(glm::cross(mesh.positions[b] - corner, mesh.positions[c] - corner));
}

/// The parts of a plant that keep one share of their triangles.
struct Part {
  double triangles = 0;
  double area = 0;  // square metres
  std::vector<double>* shares = nullptr;

  double triangles_per_area() const { return triangles / std::max(area, 1e-30); }
};

/// Returns the approximate sums of all tubes.
Part tubes_of(const Plant& plant) {
  Part tubes;
  for (const Stem& stem : plant.stems) {
    const Skeleton& skeleton = stem.skeleton;
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      const double triangles = about_tube_triangles(stem, node);
      if (triangles == 0) continue;
      const double length = glm::length(skeleton.position[node] - skeleton.position[skeleton.parent[node]]);
      tubes.triangles += triangles;
      tubes.area += 2 * kPi * length * skeleton.radius[node];
    }
  }
  return tubes;
}

constexpr std::size_t kSampledTriangles = 64;  // number of triangles that are sampled to estimate the area of a mesh

/// Returns the approximate area of a mesh in bounded time. For a large mesh, evenly chosen triangles represent all.
double about_area_of(const Mesh& mesh) {
  const std::size_t count = mesh.triangle_count();
  if (count <= kSampledTriangles) return area_of(mesh);
  double area = 0;
  for (std::size_t k = 0; k < kSampledTriangles; ++k) {
    area += triangle_area(mesh, mesh.triangles[k * count / kSampledTriangles]);
  }
  return area * static_cast<double>(count) / kSampledTriangles;
}

/// Sets the share of each part, so that all parts together have `wanted` triangles: equally many per area, but no more
/// than a part has.
void divide(std::vector<Part>& parts, double wanted, int level) {
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.triangles_per_area() < b.triangles_per_area(); });
  double area = 0;
  for (const Part& part : parts) area += part.area;
  for (const Part& part : parts) {
    const double max = area > 0 ? wanted * part.area / area : wanted;
    const double kept = std::min(part.triangles, max);
    // A level shows nothing that the level before does not show.
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
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) area += triangle_area(mesh, triangle);
  return area;
}

double about_tube_triangles(const Stem& stem, NodeIndex node) {
  if (stem.skeleton.parent[node] == kNoNode) return 0;
  const SurfaceOptions& surface = stem.part(stem.skeleton.axis[node]).surface;
  return surface.style == SurfaceOptions::Style::blend ? 0 : 2.0 * surface.sides;
}

DetailBudget::DetailBudget(const Plant& plant, const MeshDetail& detail) {
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
    part.area += glm::length(glm::cross(organ.frame.axes[0], organ.frame.axes[1]));  // area in the plane of a blade
  }
  std::map<std::string_view, Part> of_components;
  for (std::size_t k = 0; k < of_prototypes.size(); ++k) {
    const Mesh& mesh = *plant.prototypes[k].mesh;
    Part& part = of_components[plant.prototypes[k].component];
    part.triangles += of_prototypes[k].triangles * static_cast<double>(mesh.triangle_count());
    part.area += of_prototypes[k].area * (detail.is_quick ? about_area_of(mesh) : area_of(mesh));
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
