// SPDX-License-Identifier: Apache-2.0
// Replaces the nodes of each branch by nodes at equal arc distance on a natural spline. The arc is measured on short
// straight pieces, and a table of arc and chord length gives the chord parameter of each new node. Based on: see
// finish.h.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "meristem/base/curve.h"
#include "meristem/plant/finish.h"
#include "meristem/plant/further_columns.h"

namespace meristem {
namespace {

// The nodes of a branch with their chord lengths. Omits nodes at the position of their predecessor, so the chord
// lengths rise strictly.
struct Branch {
  std::vector<NodeIndex> node;
  std::vector<float> chord;

  float length() const { return chord.back(); }
};

constexpr int kSamplesPerPiece = 8;  // straight pieces per old segment that measure the arc length

/// Marks the nodes that end branches: forks, tips, nodes marked in the column `end`, and tracked nodes.
std::vector<std::uint8_t> find_ends(const Skeleton& skeleton, const NodeChildren& children,
                                    const TrackedNodes* tracked) {
  std::vector<std::uint8_t> ends(skeleton.node_count(), 0);
  const auto marks = skeleton.extra.find(kEndColumn);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const bool is_marked = marks != skeleton.extra.end() && marks->second[node] != 0;
    const bool stays = tracked != nullptr && !tracked->stays.empty() && tracked->stays[node] != 0;
    ends[node] = children.of(node).size() != 1 || is_marked || stays ? 1 : 0;
  }
  return ends;
}

Branch trace_branch(const Skeleton& skeleton, const NodeChildren& children, const std::vector<std::uint8_t>& ends,
                    NodeIndex first) {
  Branch branch{{skeleton.parent[first]}, {0}};
  for (NodeIndex node = first;; node = children.of(node)[0]) {
    const Vec3 from = skeleton.position[branch.node.back()];
    const float chord = branch.length() + glm::distance(from, skeleton.position[node]);
    const bool is_end = ends[node] != 0;
    if (chord > branch.length()) {
      branch.node.push_back(node);
      branch.chord.push_back(chord);
    } else if (is_end && branch.node.size() > 1) {
      branch.node.back() = node;
    } else if (is_end) {
      branch.node.push_back(node);
      branch.chord.push_back(0);
    }
    if (is_end) return branch;
  }
}

// The curve through the nodes of a branch as a function of chord length.
class BranchCurve {
 public:
  BranchCurve(const Skeleton& skeleton, const Branch& branch)
      : x_(coordinate(skeleton, branch, 0)), y_(coordinate(skeleton, branch, 1)), z_(coordinate(skeleton, branch, 2)) {}

  DVec3 operator()(double chord) const { return {x_(chord), y_(chord), z_(chord)}; }

 private:
  static Curve coordinate(const Skeleton& skeleton, const Branch& branch, int axis) {
    std::vector<Vec2> points;
    points.reserve(branch.node.size());
    for (std::size_t k = 0; k < branch.node.size(); ++k) {
      points.emplace_back(branch.chord[k], skeleton.position[branch.node[k]][axis]);
    }
    return Curve(std::move(points), branch.node.size() < 3 ? CurveKind::linear : CurveKind::spline);
  }

  Curve x_, y_, z_;
};

// Chord length and arc length of closely spaced points on the curve.
struct ArcTable {
  std::vector<double> chord;
  std::vector<double> arc;
};

ArcTable measure_arc(const Branch& branch, const BranchCurve& curve) {
  ArcTable table{{0}, {0}};
  DVec3 previous = curve(0);
  for (std::size_t k = 1; k < branch.node.size(); ++k) {
    const double from = branch.chord[k - 1];
    const double piece = branch.chord[k] - from;
    for (int sample = 1; sample <= kSamplesPerPiece; ++sample) {
      const double chord = from + piece * sample / kSamplesPerPiece;
      const DVec3 point = curve(chord);
      table.chord.push_back(chord);
      table.arc.push_back(table.arc.back() + glm::distance(previous, point));
      previous = point;
    }
  }
  return table;
}

// The skeleton under construction, and the new index of each old fork, root or tip.
struct Subdivision {
  const Skeleton& old;
  Skeleton result;
  std::vector<NodeIndex> renumbered;

  // Adds a node between two old ones; `share` is the weight of the second.
  NodeIndex add_between(NodeIndex parent, Vec3 position, NodeIndex low, NodeIndex high, float share) {
    const auto [min, max] = std::minmax(old.birth[low], old.birth[high]);
    const float birth = std::clamp(old.birth[low] + share * (old.birth[high] - old.birth[low]), min, max);
    const NodeIndex node = result.add_node(parent, position, birth);
    // A lateral starts with the radius of its own first node.
    const bool is_start = old.axis[low] != old.axis[high];
    result.radius[node] = is_start ? old.radius[high] : glm::mix(old.radius[low], old.radius[high], share);
    result.axis[node] = old.axis[high];
    result.order[node] = old.order[high];
    for (auto& [name, values] : result.extra) {
      const std::vector<float>& column = old.extra.find(name)->second;
      values.back() = low == high ? column[low] : inner_value(old, name, low, high, share);
    }
    return node;
  }

  NodeIndex add_copy(NodeIndex parent, NodeIndex node) {
    return renumbered[node] = add_between(parent, old.position[node], node, node, 0);
  }
};

/// A new inner node of a branch, between two old nodes.
struct InnerNode {
  Vec3 position{0};
  NodeIndex low = 0, high = 0;
  float share = 0;  ///< weight of the second old node
};

/// Returns nodes at equal arc distance on the spline through a branch.
std::vector<InnerNode> nodes_on_curve(const Skeleton& old, const Branch& branch, double spacing) {
  std::vector<InnerNode> nodes;
  const BranchCurve curve(old, branch);
  const ArcTable table = measure_arc(branch, curve);
  const double length = table.arc.back();
  const double segments = std::max(1.0, std::round(length / spacing));
  std::size_t sample = 1;
  std::size_t piece = 1;
  for (double k = 1; k < segments; ++k) {
    // Find the chord length for this arc length, and the old nodes on both sides.
    const double arc = length * k / segments;
    while (table.arc[sample] < arc) ++sample;
    const double share = (arc - table.arc[sample - 1]) / (table.arc[sample] - table.arc[sample - 1]);
    const double chord = table.chord[sample - 1] + share * (table.chord[sample] - table.chord[sample - 1]);
    while (branch.chord[piece] < chord && piece + 1 < branch.chord.size()) ++piece;
    const double from = branch.chord[piece - 1];
    const double along = (chord - from) / (branch.chord[piece] - from);
    nodes.push_back({Vec3(curve(chord)), branch.node[piece - 1], branch.node[piece], static_cast<float>(along)});
  }
  return nodes;
}

/// Returns the inner nodes of a branch, with additional nodes on the straight segments between them.
std::vector<InnerNode> nodes_on_pieces(const Skeleton& old, const Branch& branch, double spacing) {
  std::vector<InnerNode> nodes;
  for (std::size_t piece = 1; piece < branch.node.size(); ++piece) {
    const NodeIndex low = branch.node[piece - 1], high = branch.node[piece];
    const double parts = std::max(1.0, std::round((branch.chord[piece] - branch.chord[piece - 1]) / spacing));
    for (double k = 1; k < parts; ++k) {
      const auto share = static_cast<float>(k / parts);
      nodes.push_back({glm::mix(old.position[low], old.position[high], share), low, high, share});
    }
    if (piece + 1 < branch.node.size()) nodes.push_back({old.position[high], high, high, 0});
  }
  return nodes;
}

bool are_open(const Skeleton& old, const Branch& branch, const std::vector<InnerNode>& nodes, IsOpen is_open) {
  Vec3 from = old.position[branch.node.front()];
  for (const InnerNode& node : nodes) {
    if (!is_open(from, node.position)) return false;
    from = node.position;
  }
  return is_open(from, old.position[branch.node.back()]);
}

}  // namespace

Skeleton subdivide(const Skeleton& skeleton, double spacing) {
  return subdivide(skeleton, spacing, [](Vec3, Vec3) { return true; });
}

Skeleton subdivide(const Skeleton& skeleton, double spacing, IsOpen is_open, TrackedNodes* tracked) {
  if (!(spacing > 0)) throw std::invalid_argument("subdivide: the spacing must be above 0");
  const NodeChildren children(skeleton);
  const std::vector<std::uint8_t> ends = find_ends(skeleton, children, tracked);
  Subdivision subdivision{skeleton, {}, std::vector<NodeIndex>(skeleton.node_count(), kNoNode)};
  for (const auto& [name, values] : skeleton.extra) subdivision.result.extra[name];
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode) {
      subdivision.add_copy(kNoNode, node);
      continue;
    }
    // Branches begin at the children of roots and of branch ends. Both have their new index by then.
    if (!skeleton.is_root(parent) && ends[parent] == 0) continue;
    const Branch branch = trace_branch(skeleton, children, ends, node);
    NodeIndex last = subdivision.renumbered[parent];
    if (branch.length() > 0) {
      std::vector<InnerNode> nodes = nodes_on_curve(skeleton, branch, spacing);
      if (!are_open(skeleton, branch, nodes, is_open)) nodes = nodes_on_pieces(skeleton, branch, spacing);
      for (const InnerNode& inner : nodes) {
        last = subdivision.add_between(last, inner.position, inner.low, inner.high, inner.share);
      }
    }
    subdivision.add_copy(last, branch.node.back());
  }
  if (tracked != nullptr) tracked->now = std::move(subdivision.renumbered);
  return std::move(subdivision.result);
}

}  // namespace meristem
