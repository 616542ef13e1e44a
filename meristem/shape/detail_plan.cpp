// SPDX-License-Identifier: Apache-2.0
// A level of detail is made of the grown plant, not of its meshes: tubes and bodies are meshed coarser, organs are
// coarsened, then thinned by lot among neighbours (each level a part of the one before) and enlarged so that their
// area stays.
#include "meristem/shape/detail_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string_view>

#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/shape/mesh/coarsen.h"
#include "meristem/shape/mesh/even_order.h"

namespace meristem {
namespace {

constexpr float kLeastError = 0.03F;    // radii; from here on errors are doubled
constexpr float kMostError = 0.5F;      // radii; beyond, bends would be lost that are longer than the branch is thick
constexpr std::size_t kFewOrgans = 16;  // organs of a component that are always shown: they may be a tree's fruits
constexpr float kMostEnlarged = 3;      // raised, crowns stay full farther, of leaves that are plainly too large
constexpr float kLargest = 0.15F;       // of the plant's size: no leaf is enlarged beyond it, as it would be a sheet

std::uint64_t triangle_count(const TubePlan& plan) {
  std::uint64_t count = 0;
  for (const TubeSize size : plan.sizes()) count += size.triangles;
  return count;
}

/// The radius at which each axis begins, or that of the thinnest one between it and the root.
std::vector<float> thinnest_below(const Skeleton& skeleton, std::size_t axes) {
  std::vector<float> radius(axes, -1);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    float& own = radius[skeleton.axis[node]];
    if (own >= 0) continue;
    const NodeIndex parent = skeleton.parent[node];
    const float below = parent == kNoNode ? std::numeric_limits<float>::infinity() : radius[skeleton.axis[parent]];
    own = std::min(skeleton.radius[node], below);
  }
  return radius;
}

/// The plan without its thinnest axes, with no more than `triangles` triangles unless a single axis has more.
TubePlan without_thin_axes(const Skeleton& skeleton, const TubePlan& plan, std::vector<TubeWear> wears,
                           std::vector<std::uint32_t> wear_of_axis, const std::vector<std::uint32_t>& mesh_of_axis,
                           std::span<const Vec3> deformed, std::uint64_t triangles) {
  const std::vector<float> radius = thinnest_below(skeleton, plan.axis_count());
  std::vector<AxisIndex> order(plan.axis_count());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](AxisIndex a, AxisIndex b) { return radius[a] > radius[b]; });
  // Each wear has one beside it that is not to be seen.
  const auto seen = static_cast<std::uint32_t>(wears.size());
  for (std::uint32_t k = 0; k < seen; ++k) wears.push_back({wears[k].surface, wears[k].mesh, true});
  wear_of_axis.resize(plan.axis_count(), 0);
  std::uint64_t count = 0;
  bool is_first = true;
  for (const AxisIndex axis : order) {
    if (plan[axis].triangles() == 0) continue;
    count += plan[axis].triangles();
    if (count > triangles && !is_first) wear_of_axis[axis] += seen;
    is_first = false;
  }
  return {skeleton, std::move(wears), std::move(wear_of_axis), mesh_of_axis, deformed};
}

/// The numbers of each component's organs, in their order.
std::map<std::string_view, std::vector<std::uint32_t>> organs_by_component(const Plant& plant) {
  std::map<std::string_view, std::vector<std::uint32_t>> organs;
  for (std::uint32_t k = 0; k < plant.organs.size(); ++k) {
    organs[plant.prototypes[plant.organs[k].prototype].component].push_back(k);
  }
  return organs;
}

/// Sums over all organs of a component, each as large as its prototype.
struct OrganSums {
  double triangles_before = 0;  // with the plant's own meshes
  double area_before = 0;
  double triangles = 0;
  double area = 0;
};

OrganSums sums_of(const Plant& plant, const std::vector<std::uint32_t>& members,
                  const std::vector<std::shared_ptr<const Mesh>>& meshes) {
  // A component's prototypes stand together.
  const auto prototype_of = [&](std::uint32_t organ) { return plant.organs[organ].prototype; };
  OrganSums sums;
  if (members.empty()) return sums;
  const auto [first, last] = std::ranges::minmax(members, {}, prototype_of);
  std::vector<double> counts(prototype_of(last) - prototype_of(first) + 1);
  for (const std::uint32_t organ : members) ++counts[prototype_of(organ) - prototype_of(first)];
  for (std::uint32_t prototype = prototype_of(first); prototype <= prototype_of(last); ++prototype) {
    const double count = counts[prototype - prototype_of(first)];
    if (count == 0) continue;
    const Mesh& before = *plant.prototypes[prototype].mesh;
    const Mesh& mesh = *meshes[prototype];
    sums.triangles_before += count * static_cast<double>(before.triangle_count());
    sums.area_before += count * area_of(before);
    sums.triangles += count * static_cast<double>(mesh.triangle_count());
    sums.area += count * area_of(mesh);
  }
  return sums;
}

/// The box around all nodes and the feet of all organs.
Box box_of(const Plant& plant) {
  Box box;
  for (const Stem& stem : plant.stems) {
    for (const Vec3 position : stem.skeleton.position) box.add(position);
  }
  for (const Organ& organ : plant.organs) box.add(organ.frame.origin);
  return box;
}

/// The size of the largest organ of each prototype, metres.
std::vector<float> largest_organs(const Plant& plant, const std::vector<std::shared_ptr<const Mesh>>& meshes) {
  std::vector<float> size(meshes.size());
  std::vector<float> factor(meshes.size());
  for (const Organ& organ : plant.organs) {
    float& largest = factor[organ.prototype];
    for (int k = 0; k < 3; ++k) largest = std::max(largest, glm::length(organ.frame.axes[k]));
  }
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    Box box;
    for (const Vec3 position : meshes[k]->positions) box.add(position);
    size[k] = std::max(factor[k] * glm::length(box.size()), 1e-9F);
  }
  return size;
}

/// Coarsens the prototypes' meshes of the level before.
void coarsen_all(const Plant& plant, const DetailBudget& budget, int level,
                 std::vector<std::shared_ptr<const Mesh>>& meshes) {
  parallel_for(meshes.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::string& component = plant.prototypes[k].component;
      const double share = budget.of_organs(component, level) / budget.of_organs(component, level - 1);
      if (share >= 1) continue;
      const auto wanted = static_cast<std::size_t>(share * static_cast<double>(meshes[k]->triangle_count()) + 0.5);
      meshes[k] = std::make_shared<const Mesh>(coarsened(*meshes[k], wanted));
    }
  });
}

}  // namespace

TubePlan plan_tubes(const Skeleton& skeleton, const std::vector<TubeWear>& wears,
                    const std::vector<std::uint32_t>& wear_of_axis, double share,
                    const std::vector<std::uint32_t>& mesh_of_axis, std::span<const Vec3> deformed) {
  TubePlan plan(skeleton, wears, wear_of_axis, mesh_of_axis, deformed);
  if (share >= 1) return plan;
  const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(triangle_count(plan)));
  std::vector<TubeWear> coarse = wears;
  for (TubeWear& wear : coarse) {
    const double sides = wear.surface.sides * std::sqrt(share);
    wear.surface.sides = std::max(3, static_cast<int>(sides + 0.5));
  }
  plan = TubePlan(skeleton, coarse, wear_of_axis, mesh_of_axis, deformed);
  for (float error = 2 * kLeastError; triangle_count(plan) > wanted && error <= kMostError; error *= 2) {
    for (TubeWear& wear : coarse) wear.surface.error = std::max(wear.surface.error, error);
    plan = TubePlan(skeleton, coarse, wear_of_axis, mesh_of_axis, deformed);
  }
  if (triangle_count(plan) <= wanted) return plan;
  return without_thin_axes(skeleton, plan, coarse, wear_of_axis, mesh_of_axis, deformed, wanted);
}

OrganDetail plan_organs(const Plant& plant, const Detail& detail, const DetailBudget& budget) {
  OrganDetail organs;
  for (const OrganPrototype& prototype : plant.prototypes) organs.meshes.push_back(prototype.mesh);
  if (detail.level == 0) return organs;
  organs.shown.resize(plant.organs.size(), 1);
  organs.scale.resize(plant.prototypes.size(), 1);
  const auto groups = organs_by_component(plant);
  std::map<std::string_view, double> shares;
  for (int level = 1; level <= detail.level; ++level) {
    coarsen_all(plant, budget, level, organs.meshes);
    // What is left to do falls from level to level, so that none shows what one before does not.
    for (const auto& [component, members] : groups) {
      const OrganSums sums = sums_of(plant, members, organs.meshes);
      double& share = shares.try_emplace(component, 1.0).first->second;
      const double kept = budget.of_organs(component, level) * sums.triangles_before;
      share = std::min(share, kept / std::max(1.0, sums.triangles));
    }
  }
  const float size = glm::length(box_of(plant).size());
  const std::vector<float> largest = largest_organs(plant, organs.meshes);
  const RandomKey key = RandomKey().child("detail");
  for (const auto& [component, members] : groups) {
    const auto all = static_cast<double>(members.size());
    const auto wanted = static_cast<std::size_t>(all * shares.at(component));
    const std::size_t shown = std::max(std::min(members.size(), kFewOrgans), wanted);
    if (shown < members.size()) {
      const std::vector<std::uint32_t> order = even_order(members.size(), key.child(component));
      for (std::size_t k = shown; k < order.size(); ++k) organs.shown[members[order[k]]] = 0;
    }
    const OrganSums sums = sums_of(plant, members, organs.meshes);
    if (!(sums.area > 0)) continue;
    const double lost = sums.area_before * all / (sums.area * static_cast<double>(shown));
    const float scale = std::clamp(static_cast<float>(std::sqrt(lost)), 1.0F, kMostEnlarged);
    for (const std::uint32_t organ : members) {
      const std::uint32_t prototype = plant.organs[organ].prototype;
      organs.scale[prototype] = std::min(scale, std::max(1.0F, kLargest * size / largest[prototype]));
    }
  }
  return organs;
}

}  // namespace meristem
