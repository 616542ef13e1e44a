// SPDX-License-Identifier: Apache-2.0
// Cuts a skeleton at the boundary of a region. Parents come before their children, so one pass finds what is left. A
// node stays if its parent stays and the segment between them stays inside. If the segment leaves the region, a new
// node on the boundary ends the axis. Everything beyond a removed node is removed, too. A second pass sets the taper of
// shortened axes.
#include "meristem/plant/trim.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "meristem/plant/further_columns.h"

namespace meristem {

namespace {

constexpr float kShortest = 1e-6F;  // metres; a shorter rest of a segment is dropped

class Trimmer {
 public:
  Trimmer(const Skeleton& whole, StayInside stays_inside) : whole_(whole), stays_inside_(stays_inside) {
    trimmed_.node.assign(whole.node_count(), kNoNode);
    trimmed_.kept.assign(whole.node_count(), 0);
  }

  TrimmedSkeleton run(TrimMode mode) {
    find_reach();
    if (trimmed_.is_whole) return {};
    drop_bare_roots();
    add_all();
    if (mode == TrimMode::fit) fit_radii();
    if (mode == TrimMode::cut) mark_cuts();
    return std::move(trimmed_);
  }

  TrimmedSkeleton keep(std::vector<float> kept) {
    trimmed_.kept = std::move(kept);
    trimmed_.is_whole = false;
    add_all();
    return std::move(trimmed_);
  }

 private:
  void add_all() {
    for (const auto& [name, values] : whole_.extra) trimmed_.skeleton.extra[name];
    trimmed_.skeleton.operations = whole_.operations;
    axes_.assign(whole_.node_count() + 1, kNoNode);
    for (NodeIndex node = 0; node < whole_.node_count(); ++node) {
      if (trimmed_.kept[node] > 0) add(node);
    }
  }

  bool is_lateral_base(NodeIndex node) const { return whole_.axis[whole_.parent[node]] != whole_.axis[node]; }

  /// Computes the share of each segment that is left.
  void find_reach() {
    for (NodeIndex node = 0; node < whole_.node_count(); ++node) {
      const bool is_root = whole_.is_root(node);
      const NodeIndex parent = is_root ? node : whole_.parent[node];
      float kept = 0;
      if (is_root || trimmed_.kept[parent] == 1) {
        kept = stays_inside_(whole_.position[parent], whole_.position[node]);
        const float length = glm::distance(whole_.position[parent], whole_.position[node]);
        if (kept < 1 && kept * length < kShortest) kept = 0;
      }
      trimmed_.kept[node] = kept;
      trimmed_.is_whole = trimmed_.is_whole && kept == 1;
    }
  }

  void drop_bare_roots() {
    std::vector<bool> bears(whole_.node_count());
    for (NodeIndex node = 0; node < whole_.node_count(); ++node) {
      if (!whole_.is_root(node) && trimmed_.kept[node] > 0) bears[whole_.parent[node]] = true;
    }
    for (NodeIndex node = 0; node < whole_.node_count(); ++node) {
      if (whole_.is_root(node) && !bears[node]) trimmed_.kept[node] = 0;
    }
  }

  void add(NodeIndex node) {
    const bool is_root = whole_.is_root(node);
    const NodeIndex begin = is_root ? node : whole_.parent[node];
    const float share = trimmed_.kept[node];
    Skeleton& skeleton = trimmed_.skeleton;
    const NodeIndex made =
        skeleton.add_node(is_root ? kNoNode : trimmed_.node[begin],
                          glm::mix(whole_.position[begin], whole_.position[node], share), whole_.birth[node]);
    trimmed_.node[node] = made;
    const bool is_between = share < 1 && !is_lateral_base(node);  // a lateral begins with the radius of its first node
    skeleton.radius[made] =
        is_between ? glm::mix(whole_.radius[begin], whole_.radius[node], share) : whole_.radius[node];
    skeleton.order[made] = whole_.order[node];
    AxisIndex& axis = axes_[whole_.axis[node]];
    if (axis == kNoNode) axis = next_axis_++;
    skeleton.axis[made] = axis;
    for (const auto& [name, values] : whole_.extra) {
      skeleton.extra.find(name)->second[made] =
          share < 1 ? inner_value(whole_, name, begin, node, share) : values[node];
    }
  }

  /// Marks cut axes: those with a shortened segment, and those whose next segment was removed completely.
  void mark_cuts() {
    std::vector<float>& cut = trimmed_.skeleton.extra[std::string(kCutColumn)];
    cut.resize(trimmed_.skeleton.node_count());
    for (NodeIndex node = 0; node < whole_.node_count(); ++node) {
      if (trimmed_.kept[node] == 1 || whole_.is_root(node)) continue;
      if (trimmed_.kept[node] > 0) {
        cut[trimmed_.node[node]] = 1;
      } else if (!is_lateral_base(node) && trimmed_.kept[whole_.parent[node]] == 1) {
        cut[trimmed_.node[whole_.parent[node]]] = 1;
      }
    }
  }

  void fit_radii() {
    Skeleton& skeleton = trimmed_.skeleton;
    const SkeletonAxes before(whole_);
    const std::vector<float> arcs = arcs_along_axes(whole_);
    const std::vector<float> new_arcs = arcs_along_axes(skeleton);
    const SkeletonAxes after(skeleton);
    std::vector<AxisIndex> whole_axis(after.count(), 0);
    for (AxisIndex axis = 0; axis < before.count(); ++axis) {
      if (axes_[axis] != kNoNode) whole_axis[axes_[axis]] = axis;
    }
    // Axes are numbered in the order of their first nodes, so the radii of the bearing axis are already set.
    for (AxisIndex axis = 0; axis < after.count(); ++axis) {
      const std::span<const NodeIndex> nodes = after.of(axis);
      const std::span<const NodeIndex> old = before.of(whole_axis[axis]);
      const float length = new_arcs[nodes.back()];
      const float stretch = length > 0 ? arcs[old.back()] / length : 1;
      const NodeIndex bearer = skeleton.parent[nodes[0]];
      // A stem of another length has the same form, so its thickness is in proportion to its length.
      float scale = stretch > 1 ? 1 / stretch : 1;
      if (bearer != kNoNode) scale = std::min(scale, skeleton.radius[bearer] / whole_.radius[old[0]]);
      std::size_t next = 0;
      for (const NodeIndex node : nodes) {
        const float at = std::min(new_arcs[node] * stretch, arcs[old.back()]);
        while (next + 1 < old.size() && arcs[old[next]] < at) ++next;
        float radius = whole_.radius[old[next]];
        if (next > 0 && arcs[old[next]] > arcs[old[next - 1]]) {
          const float share = (at - arcs[old[next - 1]]) / (arcs[old[next]] - arcs[old[next - 1]]);
          radius = glm::mix(whole_.radius[old[next - 1]], radius, std::clamp(share, 0.0F, 1.0F));
        }
        skeleton.radius[node] = scale * radius;
      }
    }
  }

  const Skeleton& whole_;
  StayInside stays_inside_;
  TrimmedSkeleton trimmed_;
  std::vector<AxisIndex> axes_;  // number in the trimmed skeleton of each axis of the whole one
  AxisIndex next_axis_ = 0;
};

}  // namespace

std::vector<float> arcs_along_axes(const Skeleton& skeleton) {
  std::vector<float> arc(skeleton.node_count(), 0);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.is_root(node)) continue;
    const NodeIndex parent = skeleton.parent[node];
    const bool goes_on = skeleton.axis[parent] == skeleton.axis[node];
    arc[node] = (goes_on ? arc[parent] : 0) + glm::distance(skeleton.position[parent], skeleton.position[node]);
  }
  return arc;
}

TrimmedSkeleton keep_shares(const Skeleton& whole, std::vector<float> kept) {
  const auto all = [](Vec3, Vec3) { return 1.0F; };
  return Trimmer(whole, all).keep(std::move(kept));
}

TrimmedSkeleton one_after_other(TrimmedSkeleton first, TrimmedSkeleton then) {
  for (std::size_t node = 0; node < first.node.size(); ++node) {
    if (!(first.kept[node] > 0)) continue;
    const NodeIndex between = first.node[node];
    first.kept[node] *= then.kept[between];
    first.node[node] = then.node[between];
  }
  first.skeleton = std::move(then.skeleton);
  return first;
}

TrimmedSkeleton trim_skeleton(const Skeleton& whole, StayInside stays_inside, TrimMode mode) {
  assert(mode != TrimMode::none);
  return Trimmer(whole, stays_inside).run(mode);
}

}  // namespace meristem
