// SPDX-License-Identifier: Apache-2.0
// Joins stems that stand on other stems into one skeleton, whatever model made them. The graph records where each stem
// stands. After growth, a stem becomes a lateral of the stem that bears it. A stem that begins too far from its parent
// stays separate.
#include "meristem/plant/join_stems.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "meristem/base/random.h"
#include "meristem/plant/further_columns.h"
#include "meristem/plant/operation_record.h"

namespace meristem {

namespace {

/// The position on a parent's segment where a child stem begins.
struct Graft {
  NodeIndex node = 0;
  float along = 1;
  std::uint32_t child = 0;
};

Vec3 position_on(const Skeleton& stem, NodeIndex node, float along) {
  if (stem.is_root(node)) return stem.position[node];
  return glm::mix(stem.position[stem.parent[node]], stem.position[node], along);
}

std::uint64_t name_of_axis(const LooseStem& stem, AxisIndex axis) {
  return RandomKey(stem.name).child(stem.number_of_axis.empty() ? axis : stem.number_of_axis[axis]).bits();
}

bool has_single_root(const Skeleton& skeleton) {
  if (skeleton.node_count() < 2) return false;
  return std::count(skeleton.parent.begin(), skeleton.parent.end(), kNoNode) == 1;
}

bool can_join(const LooseStem& stem, const std::vector<LooseStem>& stems, float reach) {
  if (stem.parent == kNoStem || !has_single_root(*stem.skeleton)) return false;
  const Skeleton& parent = *stems[stem.parent].skeleton;
  if (stem.node >= parent.node_count()) return false;
  const Vec3 position = position_on(parent, stem.node, stem.along);
  return glm::distance(position, stem.skeleton->position[0]) <= reach * parent.radius[stem.node] + 1e-4F;
}

/// Joins the stems of one tree into one skeleton, parents before children.
class TreeJoiner {
 public:
  TreeJoiner(std::vector<LooseStem>& stems, std::vector<std::vector<Graft>>& grafts)
      : stems_(stems), grafts_(grafts), joints_(stems.size()) {}

  Stem join(std::span<const std::uint32_t> members) {
    std::size_t nodes = 0;
    for (const std::uint32_t member : members) nodes += stems_[member].skeleton->node_count() + 1;
    tree_ = {};
    tree_.parts.clear();
    tree_.parts.reserve(members.size());
    tree_.skeleton.reserve(nodes);
    for (const std::uint32_t member : members) add_stem(member, member == members[0]);
    tree_.individual_of_root = std::move(stems_[members[0]].individual_of_root);
    return std::move(tree_);
  }

 private:
  /// The node that replaces a child's root, and its branching order in the parent.
  struct Joint {
    NodeIndex node = kNoNode;
    std::uint16_t order = 0;
  };

  void add_stem(std::uint32_t member, bool is_root) {
    LooseStem& stem = stems_[member];
    member_ = member;
    part_ = static_cast<std::uint32_t>(tree_.parts.size());
    tree_.parts.push_back(std::move(stem.part));
    const Skeleton& from = *stem.skeleton;
    for (OperationRecord record : from.operations) {
      record.part = part_;
      tree_.skeleton.operations.add(std::move(record));
    }
    const Joint joint = joints_[member];
    order_ = is_root ? 0 : joint.order + 1;
    // Number each axis when its first node is added.
    axis_of_.assign(from.node_count(), kNoNode);
    node_of_.assign(from.node_count(), kNoNode);
    const std::vector<Graft>& grafts = grafts_[member];
    auto next = grafts.begin();
    for (NodeIndex node = 0; node < from.node_count(); ++node) {
      NodeIndex parent = from.is_root(node) ? kNoNode : node_of_[from.parent[node]];
      float last_along = -1;
      for (; next != grafts.end() && next->node == node; ++next) {
        const bool is_between = !from.is_root(node) && next->along < kAtEnd;
        if (!is_between) break;
        // Stems of a whorl share one node.
        if (next->along > last_along) parent = add_between(from, node, next->along, parent);
        last_along = next->along;
        joints_[next->child] = {parent, tree_.skeleton.order[parent]};
      }
      const bool gives_way = !is_root && node == 0;
      node_of_[node] = gives_way ? joint.node : add_node(from, node, parent);
      for (; next != grafts.end() && next->node == node; ++next) {
        joints_[next->child] = {node_of_[node], tree_.skeleton.order[node_of_[node]]};
      }
    }
    stem.skeleton = nullptr;
    stem.own = nullptr;
  }

  NodeIndex add_node(const Skeleton& from, NodeIndex node, NodeIndex parent) {
    const NodeIndex made = tree_.skeleton.add_node(parent, from.position[node], from.birth[node]);
    tree_.skeleton.radius[made] = from.radius[node];
    place_on_axis(from, node, made);
    for (const auto& [name, values] : from.extra) column(name)[made] = values[node];
    return made;
  }

  NodeIndex add_between(const Skeleton& from, NodeIndex node, float along, NodeIndex parent) {
    const NodeIndex begin = from.parent[node];
    const auto between = [&](const auto& values) { return glm::mix(values[begin], values[node], along); };
    const NodeIndex made = tree_.skeleton.add_node(parent, between(from.position), between(from.birth));
    // A lateral starts with the radius of its own first node.
    const bool is_start = from.axis[begin] != from.axis[node];
    tree_.skeleton.radius[made] = is_start ? from.radius[node] : between(from.radius);
    place_on_axis(from, node, made);
    for (const auto& [name, values] : from.extra) {
      column(name)[made] = inner_value(from, name, begin, node, along);
    }
    return made;
  }

  void place_on_axis(const Skeleton& from, NodeIndex node, NodeIndex made) {
    AxisIndex& axis = axis_of_[from.axis[node]];
    if (axis == kNoNode) {
      axis = static_cast<AxisIndex>(tree_.part_of_axis.size());
      tree_.part_of_axis.push_back(part_);
      tree_.axis_names.push_back(name_of_axis(stems_[member_], from.axis[node]));
    }
    tree_.skeleton.axis[made] = axis;
    tree_.skeleton.order[made] = static_cast<std::uint16_t>(order_ + from.order[node]);
  }

  std::vector<float>& column(const std::string& name) {
    std::vector<float>& values = tree_.skeleton.extra[name];
    values.resize(tree_.skeleton.node_count(), 0);
    return values;
  }

  static constexpr float kAtEnd = 0.999F;  // closer to a segment's end than this, the child uses the existing node

  std::vector<LooseStem>& stems_;
  std::vector<std::vector<Graft>>& grafts_;
  std::vector<Joint> joints_;  // one for each stem
  Stem tree_;
  std::uint32_t part_ = 0;
  std::uint32_t member_ = 0;  // the stem that is being added
  int order_ = 0;
  std::vector<AxisIndex> axis_of_;
  std::vector<NodeIndex> node_of_;
};

/// The stems of each tree.
class Members {
 public:
  /// `root` has the first stem of the tree of each stem.
  explicit Members(const std::vector<std::uint32_t>& root) : first_(root.size() + 1), members_(root.size()) {
    for (const std::uint32_t tree : root) ++first_[tree + 1];
    for (std::size_t k = 0; k < root.size(); ++k) {
      if (first_[k + 1] > 0) ++tree_count_;
      first_[k + 1] += first_[k];
    }
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t k = 0; k < root.size(); ++k) members_[next[root[k]]++] = k;
  }

  std::size_t tree_count() const { return tree_count_; }
  /// Returns the stems of the tree with this first stem, in their order.
  std::span<const std::uint32_t> of(std::uint32_t root) const {
    return std::span(members_).subspan(first_[root], first_[root + 1] - first_[root]);
  }

 private:
  std::vector<std::uint32_t> first_;  // begin of each tree in `members_`; one entry more than stems
  std::vector<std::uint32_t> members_;
  std::size_t tree_count_ = 0;
};

}  // namespace

std::vector<Stem> join_stems(std::vector<LooseStem> stems, float reach) {
  // Find the tree of each stem, and the children of each stem.
  std::vector<std::uint32_t> root(stems.size());
  std::vector<std::vector<Graft>> grafts(stems.size());
  for (std::uint32_t k = 0; k < stems.size(); ++k) {
    const bool joins = can_join(stems[k], stems, reach);
    root[k] = joins ? root[stems[k].parent] : k;
    if (joins) grafts[stems[k].parent].push_back({stems[k].node, stems[k].along, k});
  }
  for (std::vector<Graft>& borne : grafts) {
    std::stable_sort(borne.begin(), borne.end(), [](const Graft& a, const Graft& b) {
      return a.node != b.node ? a.node < b.node : a.along < b.along;
    });
  }
  const Members members(root);
  // A stem without children stays as it is.
  std::vector<Stem> joined;
  joined.reserve(members.tree_count());
  TreeJoiner joiner(stems, grafts);
  for (std::uint32_t k = 0; k < stems.size(); ++k) {
    if (root[k] != k) continue;
    if (members.of(k).size() > 1) {
      joined.push_back(joiner.join(members.of(k)));
      continue;
    }
    Stem& stem = joined.emplace_back();
    stem.parts[0] = std::move(stems[k].part);
    if (stems[k].own != nullptr) {
      stem.skeleton = std::move(*stems[k].own);
    } else {
      stem.skeleton = *stems[k].skeleton;
    }
    stem.individual_of_root = std::move(stems[k].individual_of_root);
    const auto count = static_cast<AxisIndex>(stem.skeleton.axis_count());
    stem.axis_names.reserve(count);
    for (AxisIndex axis = 0; axis < count; ++axis) stem.axis_names.push_back(name_of_axis(stems[k], axis));
    stems[k].skeleton = nullptr;
    stems[k].own = nullptr;
  }
  return joined;
}

}  // namespace meristem
