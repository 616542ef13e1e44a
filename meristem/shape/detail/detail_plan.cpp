// SPDX-License-Identifier: Apache-2.0
// Makes a level of detail from the grown plant and not from its meshes. Tubes and bodies are meshed coarser. Organs are
// coarsened, then thinned out at random among neighbours and enlarged so that their area stays. Each level is a subset
// of the level before.
#include "meristem/shape/detail/detail_plan.h"

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

constexpr float kMinError = 0.03F;  // in radii; errors are doubled from this value on
constexpr float kMaxError = 0.5F;   // in radii; larger errors would remove bends that are longer than the thickness
                                    // of the branch
constexpr std::uint32_t kLongestQuickRun = 100;  // maximum number of nodes per ring in a quick detail
constexpr float kMaxQuickError = 4;              // in radii
constexpr std::size_t kFewOrgans = 16;  // number of organs of a component that are always shown, because they may be a
                                        // tree's fruits
constexpr double kTrianglesOfFew = 8;   // kept triangles per always shown organ, in a quick detail
constexpr float kMaxEnlarged = 3;       // maximum enlargement; more keeps crowns full at a larger distance, but leaves
                                        // look too large
constexpr float kLargest = 0.15F;       // maximum size of an enlarged leaf as a share of the plant's size; larger ones
                                        // look like sheets

std::uint64_t triangle_count(const TubePlan& plan) {
  std::uint64_t count = 0;
  for (const TubeSize size : plan.sizes()) count += size.triangles;
  return count;
}

/// Returns the radius at which each axis begins, or the smallest such radius between the axis and the root.
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

/// The surfaces of the axes of a skeleton.
struct AxisWears {
  std::vector<TubeWear> wears;
  std::vector<std::uint32_t> of_axis;
};

/// Leaves out the thinnest axes until at most `triangles` triangles remain, unless a single axis has more.
/// `triangles_of` returns the triangles of an axis.
template <class TrianglesOf>
AxisWears without_thin_axes(const Skeleton& skeleton, std::size_t axes, AxisWears worn, double triangles,
                            const TrianglesOf& triangles_of) {
  const std::vector<float> radius = thinnest_below(skeleton, axes);
  std::vector<AxisIndex> order(axes);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](AxisIndex a, AxisIndex b) { return radius[a] > radius[b]; });
  // Each surface has a copy that is left out.
  const auto seen = static_cast<std::uint32_t>(worn.wears.size());
  for (std::uint32_t k = 0; k < seen; ++k) {
    TubeWear& hidden = worn.wears.emplace_back(worn.wears[k]);
    hidden.left_out = true;
  }
  worn.of_axis.resize(axes, 0);
  double count = 0;
  bool is_first = true;
  for (const AxisIndex axis : order) {
    const auto of_axis = static_cast<double>(triangles_of(axis));
    if (of_axis == 0) continue;
    count += of_axis;
    if (count > triangles && !is_first) worn.of_axis[axis] += seen;
    is_first = false;
  }
  return worn;
}

/// Returns the minimum number of triangles of each axis's tube.
std::vector<std::uint32_t> fewest_triangles(const Skeleton& skeleton, const AxisWears& worn) {
  std::vector<std::uint32_t> nodes;
  for (const AxisIndex axis : skeleton.axis) {
    if (axis >= nodes.size()) nodes.resize(axis + 1, 0);
    ++nodes[axis];
  }
  for (AxisIndex axis = 0; axis < nodes.size(); ++axis) {
    const TubeWear& wear = worn.wears[worn.of_axis.empty() ? 0 : worn.of_axis[axis]];
    const bool is_tube = wear.surface.style == SurfaceOptions::Style::tubes && !wear.left_out;
    nodes[axis] = is_tube ? 6 * (2 + nodes[axis] / kLongestQuickRun) : 0;  // three sides
  }
  return nodes;
}

/// The limit of triangles for coarse tubes.
struct CoarseTubes {
  double share = 1;             // of all triangles
  std::uint64_t wanted = 0;     // number of triangles
  float max_error = kMaxError;  // in radii
};

/// Reduces sides, then rings, then axes, until a plan of `worn` has the wanted triangles.
TubePlan plan_coarse_tubes(const Skeleton& skeleton, AxisWears worn, const CoarseTubes& coarse,
                           const std::vector<std::uint32_t>& mesh_of_axis, std::span<const Vec3> deformed) {
  const auto& [share, wanted, max_error] = coarse;
  for (TubeWear& wear : worn.wears) {
    const double sides = wear.surface.sides * std::sqrt(share);
    wear.surface.sides = std::max(3, static_cast<int>(sides + 0.5));
  }
  TubePlan plan(skeleton, worn.wears, worn.of_axis, mesh_of_axis, deformed);
  for (float error = 2 * kMinError; triangle_count(plan) > wanted && error <= max_error; error *= 2) {
    for (TubeWear& wear : worn.wears) wear.surface.error = std::max(wear.surface.error, error);
    plan = TubePlan(skeleton, worn.wears, worn.of_axis, mesh_of_axis, deformed);
  }
  if (triangle_count(plan) <= wanted) return plan;
  worn = without_thin_axes(skeleton, plan.axis_count(), std::move(worn), static_cast<double>(wanted),
                           [&](AxisIndex axis) { return plan[axis].triangles(); });
  return {skeleton, std::move(worn.wears), std::move(worn.of_axis), mesh_of_axis, deformed};
}

/// Returns the numbers of each component's organs, in their order.
std::map<std::string_view, std::vector<std::uint32_t>> organs_by_component(const Plant& plant) {
  std::map<std::string_view, std::vector<std::uint32_t>> organs;
  for (std::uint32_t k = 0; k < plant.organs.size(); ++k) {
    organs[plant.prototypes[plant.organs[k].prototype].component].push_back(k);
  }
  return organs;
}

/// Sums over all organs of a component, each of the size of its prototype.
struct OrganSums {
  double triangles_before = 0;  // with the plant's own meshes
  double area_before = 0;
  double triangles = 0;
  double area = 0;
};

OrganSums sums_of(const Plant& plant, const std::vector<std::uint32_t>& members,
                  const std::vector<std::shared_ptr<const Mesh>>& meshes) {
  // Group the organs by prototype.
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

/// Returns the box around all nodes and all points of attachment of organs.
Box box_of(const Plant& plant) {
  Box box;
  for (const Stem& stem : plant.stems) {
    for (const Vec3 position : stem.skeleton.position) box.add(position);
  }
  for (const Organ& organ : plant.organs) box.add(organ.frame.origin);
  return box;
}

/// Returns the size of the largest organ of each prototype, in metres. Considers only organs that are `shown`, if it is
/// not empty.
std::vector<float> largest_organs(const Plant& plant, const std::vector<std::shared_ptr<const Mesh>>& meshes,
                                  const std::vector<std::uint8_t>& shown = {}) {
  std::vector<float> size(meshes.size());
  std::vector<float> factor(meshes.size());
  for (std::size_t i = 0; i < plant.organs.size(); ++i) {
    if (!shown.empty() && shown[i] == 0) continue;
    const Organ& organ = plant.organs[i];
    float& largest = factor[organ.prototype];
    for (int k = 0; k < 3; ++k) largest = std::max(largest, glm::length(organ.frame.axes[k]));
  }
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    if (!shown.empty() && factor[k] == 0) continue;
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

/// The organs of one component in a quick detail.
struct OrganChoice {
  const std::vector<std::uint32_t>* members = nullptr;
  std::vector<std::uint32_t> order{};  // order of members; the first ones are shown; empty: all are shown
  double share = 1;                    // share of their triangles
  double kept = 0;                     // number of triangles
  std::size_t few = 1;                 // number of organs that are always shown
  std::size_t shown = 0;

  std::uint32_t organ(std::size_t k) const { return (*members)[order.empty() ? k : order[k]]; }
};

/// Chooses as many organs as the kept triangles allow, if each mesh can be coarsened as planned.
OrganChoice choose_organs(const Plant& plant, std::string_view component, const std::vector<std::uint32_t>& members,
                          double share) {
  OrganChoice choice{.members = &members, .share = share, .shown = members.size()};
  double before = 0;
  double coarse = 0;
  for (const std::uint32_t organ : members) {
    const auto triangles = static_cast<double>(plant.prototypes[plant.organs[organ].prototype].mesh->triangle_count());
    before += triangles;
    coarse += std::min(triangles, std::max(2.0, share * triangles));
  }
  choice.kept = share * before;
  if (share >= 1) return choice;
  const auto all = static_cast<double>(members.size());
  choice.few = static_cast<std::size_t>(std::clamp(choice.kept / kTrianglesOfFew, 1.0, double{kFewOrgans}));
  const auto wanted = static_cast<std::size_t>(all * std::min(1.0, choice.kept / std::max(1.0, coarse)));
  choice.shown = std::min(members.size(), std::max(wanted, choice.few));
  choice.order = even_order(members.size(), RandomKey().child("detail").child(component));
  return choice;
}

/// Coarsens the meshes of the chosen organs.
void coarsen_chosen(const Plant& plant, const std::vector<OrganChoice>& choices, const MeshDetail& detail,
                    std::vector<std::shared_ptr<const Mesh>>& meshes) {
  std::vector<double> share(meshes.size(), 1);
  for (const OrganChoice& choice : choices) {
    for (std::size_t k = 0; k < choice.shown; ++k) share[plant.organs[choice.organ(k)].prototype] = choice.share;
  }
  parallel_for(meshes.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (share[k] >= 1) continue;
      const std::size_t triangles = meshes[k]->triangle_count();
      if (detail.work != nullptr) detail.work->triangles += triangles;
      const auto wanted = static_cast<std::size_t>(share[k] * static_cast<double>(triangles) + 0.5);
      meshes[k] = std::make_shared<const Mesh>(quickly_coarsened(*meshes[k], wanted));
    }
  });
}

/// Shows fewer organs if their meshes have more triangles than planned.
void keep_to_budget(const Plant& plant, const std::vector<std::shared_ptr<const Mesh>>& meshes, OrganChoice& choice) {
  if (choice.share >= 1) return;
  double triangles = 0;
  for (std::size_t k = 0; k < choice.shown; ++k) {
    triangles += static_cast<double>(meshes[plant.organs[choice.organ(k)].prototype]->triangle_count());
    if (triangles > choice.kept && k >= choice.few) choice.shown = k;
  }
}

/// Returns the factor on the length of the shown organs that restores the area of all organs.
float enlargement(const Plant& plant, const std::vector<std::shared_ptr<const Mesh>>& meshes,
                  const OrganChoice& choice) {
  std::map<std::uint32_t, double> counts;
  for (std::size_t k = 0; k < choice.shown; ++k) ++counts[plant.organs[choice.organ(k)].prototype];
  double before = 0;
  double area = 0;
  for (const auto& [prototype, count] : counts) {
    before += count * area_of(*plant.prototypes[prototype].mesh);
    area += count * area_of(*meshes[prototype]);
  }
  if (!(area > 0)) return 1;
  const double lost = before / area * static_cast<double>(choice.members->size()) / static_cast<double>(choice.shown);
  return std::clamp(static_cast<float>(std::sqrt(lost)), 1.0F, kMaxEnlarged);
}

OrganDetail plan_organs_quickly(const Plant& plant, const MeshDetail& detail, const DetailBudget& budget) {
  OrganDetail organs;
  for (const OrganPrototype& prototype : plant.prototypes) organs.meshes.push_back(prototype.mesh);
  organs.shown.resize(plant.organs.size(), 0);
  organs.scale.resize(plant.prototypes.size(), 1);
  const auto groups = organs_by_component(plant);
  std::vector<OrganChoice> choices;
  for (const auto& [component, members] : groups) {
    choices.push_back(choose_organs(plant, component, members, budget.of_organs(component, detail.level)));
  }
  coarsen_chosen(plant, choices, detail, organs.meshes);
  for (OrganChoice& choice : choices) {
    keep_to_budget(plant, organs.meshes, choice);
    for (std::size_t k = 0; k < choice.shown; ++k) organs.shown[choice.organ(k)] = 1;
  }
  const float size = glm::length(box_of(plant).size());
  const std::vector<float> largest = largest_organs(plant, organs.meshes, organs.shown);
  for (const OrganChoice& choice : choices) {
    if (choice.share >= 1) continue;
    const float scale = enlargement(plant, organs.meshes, choice);
    for (std::size_t k = 0; k < choice.shown; ++k) {
      const std::uint32_t prototype = plant.organs[choice.organ(k)].prototype;
      organs.scale[prototype] = std::min(scale, std::max(1.0F, kLargest * size / largest[prototype]));
    }
  }
  return organs;
}

}  // namespace

TubePlan plan_tubes(const Skeleton& skeleton, const std::vector<TubeWear>& wears,
                    const std::vector<std::uint32_t>& wear_of_axis, double share,
                    const std::vector<std::uint32_t>& mesh_of_axis, std::span<const Vec3> deformed) {
  TubePlan plan(skeleton, wears, wear_of_axis, mesh_of_axis, deformed);
  if (share >= 1) return plan;
  const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(triangle_count(plan)));
  return plan_coarse_tubes(skeleton, {wears, wear_of_axis}, {share, wanted}, mesh_of_axis, deformed);
}

TubePlan plan_quick_tubes(const Skeleton& skeleton, const std::vector<TubeWear>& wears,
                          const std::vector<std::uint32_t>& wear_of_axis, double triangles, double all,
                          const std::vector<std::uint32_t>& mesh_of_axis, std::span<const Vec3> deformed) {
  if (triangles >= all) return TubePlan(skeleton, wears, wear_of_axis, mesh_of_axis, deformed);
  AxisWears worn{wears, wear_of_axis};
  for (TubeWear& wear : worn.wears) wear.longest_run = kLongestQuickRun;
  const std::vector<std::uint32_t> fewest = fewest_triangles(skeleton, worn);
  worn = without_thin_axes(skeleton, fewest.size(), std::move(worn), triangles,
                           [&](AxisIndex axis) { return fewest[axis]; });
  const CoarseTubes coarse{triangles / all, static_cast<std::uint64_t>(triangles), kMaxQuickError};
  return plan_coarse_tubes(skeleton, std::move(worn), coarse, mesh_of_axis, deformed);
}

OrganDetail plan_organs(const Plant& plant, const MeshDetail& detail, const DetailBudget& budget) {
  OrganDetail organs;
  for (const OrganPrototype& prototype : plant.prototypes) organs.meshes.push_back(prototype.mesh);
  if (detail.level == 0) return organs;
  if (detail.is_quick) return plan_organs_quickly(plant, detail, budget);
  organs.shown.resize(plant.organs.size(), 1);
  organs.scale.resize(plant.prototypes.size(), 1);
  const auto groups = organs_by_component(plant);
  std::map<std::string_view, double> shares;
  for (int level = 1; level <= detail.level; ++level) {
    coarsen_all(plant, budget, level, organs.meshes);
    // The remaining share falls from level to level, so that no level shows more than the level before.
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
    const float scale = std::clamp(static_cast<float>(std::sqrt(lost)), 1.0F, kMaxEnlarged);
    for (const std::uint32_t organ : members) {
      const std::uint32_t prototype = plant.organs[organ].prototype;
      organs.scale[prototype] = std::min(scale, std::max(1.0F, kLargest * size / largest[prototype]));
    }
  }
  return organs;
}

}  // namespace meristem
