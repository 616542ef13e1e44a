// SPDX-License-Identifier: Apache-2.0
// Measures the form of one tree: counts, height, stems at breast height, and the crown. The crown begins at the first
// fork. Its widths and areas come from convex hulls of its nodes.
#include "meristem/measure/tree_form.h"

#include <algorithm>

#include "meristem/measure/convex_hull.h"
#include "meristem/plant/axis_labels.h"

namespace meristem {
namespace {

/// Sums and counts that need one pass over the nodes.
void count_nodes(const Skeleton& skeleton, const NodeChildren& children, TreeForm& form) {
  const DVec3 root(skeleton.position[0]);
  form.nodes = skeleton.node_count();
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const DVec3 position(skeleton.position[node]);
    const std::size_t order = skeleton.order[node];
    if (form.axes_by_order.size() <= order) {
      form.axes_by_order.resize(order + 1, 0);
      form.length_by_order.resize(order + 1, 0);
    }
    const std::size_t degree = children.of(node).size();
    if (degree == 0) ++form.tips;
    if (degree > 1) ++form.forks;
    form.node_sum += position - root;
    form.height = std::max(form.height, position.y - root.y);
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode || skeleton.axis[node] != skeleton.axis[parent]) ++form.axes_by_order[order];
    if (parent == kNoNode) continue;
    const DVec3 segment = position - DVec3(skeleton.position[parent]);
    form.segment_sum += segment;
    form.length_by_order[order] += glm::length(segment);
  }
}

std::uint64_t count_metamers(const Skeleton& skeleton) {
  const auto column = skeleton.extra.find(kMetamerColumn);
  if (column == skeleton.extra.end()) return skeleton.node_count() - 1;
  const std::vector<float>& metamer = column->second;
  std::uint64_t count = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (!(metamer[node] >= 1)) continue;
    const NodeIndex parent = skeleton.parent[node];
    const bool goes_on = parent != kNoNode && skeleton.axis[parent] == skeleton.axis[node];
    if (!goes_on || metamer[parent] != metamer[node]) ++count;
  }
  return count;
}

/// Returns the diameters of all shoots where a path from the root first rises past breast height. Shoots that come down
/// again from above, as in a weeping crown, do not count.
std::vector<double> diameters_at_breast_height(const Skeleton& skeleton) {
  const double level = double{skeleton.position[0].y} + kBreastHeight;
  std::vector<double> diameters;
  std::vector<bool> is_below(skeleton.node_count(), false);  // true if the whole path from the root stays below
  is_below[0] = true;
  for (NodeIndex node = 1; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (!is_below[parent]) continue;
    if (skeleton.position[node].y < level) {
      is_below[node] = true;
      continue;
    }
    // A lateral has the thickness of its own first node from its beginning within the parent.
    const bool goes_on = skeleton.axis[node] == skeleton.axis[parent];
    const double below = skeleton.position[parent].y;
    const double share = goes_on ? (level - below) / (skeleton.position[node].y - below) : 1;
    const double radius = skeleton.radius[parent] + share * (skeleton.radius[node] - skeleton.radius[parent]);
    if (radius > 0) diameters.push_back(2 * radius);
  }
  return diameters;
}

void measure_stems(const Skeleton& skeleton, TreeForm& form) {
  form.base_diameter = 2 * skeleton.radius[0];
  const std::vector<double> diameters = diameters_at_breast_height(skeleton);
  if (diameters.empty()) return;
  form.diameter = *std::max_element(diameters.begin(), diameters.end());
  for (const double diameter : diameters) {
    if (diameter < kStemShare * *form.diameter) continue;
    ++form.stems;
    form.diameter_squares += diameter * diameter;
  }
}

/// Finds the first fork. Returns for each node whether it belongs to the crown beyond this fork.
std::vector<bool> find_crown(const Skeleton& skeleton, const NodeChildren& children, TreeForm& form) {
  std::vector<bool> in_crown(skeleton.node_count(), true);
  NodeIndex node = 0;
  in_crown[node] = false;
  while (children.of(node).size() == 1) {
    node = children.of(node)[0];
    in_crown[node] = false;
  }
  if (children.of(node).size() > 1) form.fork = node;
  return in_crown;
}

void measure_crown(const Skeleton& skeleton, const NodeChildren& children, const Progress* progress, TreeForm& form) {
  const std::vector<bool> in_crown = find_crown(skeleton, children, form);
  if (!form.fork) return;
  const double base = skeleton.position[*form.fork].y;
  std::vector<Vec3> crown;
  std::vector<Vec2> seen_from_above;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (!in_crown[node]) continue;
    const Vec3 position = skeleton.position[node];
    crown.push_back(position);
    seen_from_above.emplace_back(position.x, position.z);
    form.crown_height = std::max(form.crown_height, position.y - base);
  }
  const OutlineSize outline = measure_outline(convex_outline(std::move(seen_from_above)));
  form.crown_width = outline.diameter;
  // Cauchy: the extent of a convex outline, averaged over all directions, is its perimeter divided by pi.
  form.crown_mean_width = outline.perimeter / kPi;
  form.crown_ground_area = outline.area;
  form.crown_hull = convex_hull(crown, progress);
  form.crown_hull_area = surface_area_of(form.crown_hull);
  form.crown_hull_volume = volume_of(form.crown_hull);
}

}  // namespace

TreeForm measure_form(const Skeleton& skeleton, const NodeChildren& children, const Progress* progress) {
  TreeForm form;
  if (skeleton.node_count() == 0) return form;
  count_nodes(skeleton, children, form);
  form.metamers = count_metamers(skeleton);
  measure_stems(skeleton, form);
  measure_crown(skeleton, children, progress, form);
  return form;
}

}  // namespace meristem
