// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/grow/colonize/nearest_nodes.h"
#include "meristem/grow/stand.h"

namespace meristem {

/// What the points of one node pull it toward.
struct Pull {
  NodeIndex node = 0;  ///< counted within its tree
  DVec3 sum{0};        ///< of the unit vectors from the node to its points
};

/// The attraction points of all trees of a stand, which compete for them: a point belongs to the nearest node within
/// its tree's influence distance, whichever tree brought the point, and is used up when that node is within its tree's
/// kill distance. Places are relative to the first tree's root, so that a stand far from the world's origin loses no
/// digits; each tree speaks of places relative to its own root.
class AttractionCloud : public Commons {
 public:
  using Tree = std::uint32_t;

  /// A tree with its root at `root` (world space) that brings `points` (world space); its root is its node 0. Distances
  /// in metres, above 0. To be called before the first round.
  Tree join(Vec3 root, const std::vector<Vec3>& points, double influence, double kill);
  /// A new node of a tree; its points are counted from the next round on.
  void add_node(Tree tree, Vec3 position);

  /// Which of a tree's nodes are pulled in this round and where to, by rising index. Sums are of whole numbers (unit
  /// vectors in steps of 2^-38), so they do not depend on the order of the points.
  std::span<const Pull> pulls(Tree tree) const { return trees_[tree].pulls; }
  /// Whether the tree's newest nodes used up a point or came nearer to one.
  bool has_advanced(Tree tree) const { return trees_[tree].advances > 0; }
  /// The living point nearest to a tree's root. Costs as much as a search in a tree of points.
  std::optional<Vec3> nearest_point(Tree tree) const;

  std::uint64_t node_count() const { return nodes_.size() + new_nodes_.size(); }
  std::uint64_t point_count() const { return nearest_ ? nearest_->living() : points_.size(); }

  void begin_round(Progress& progress) override;

 private:
  struct Member {
    Vec3 offset{0};  // its root relative to the cloud's origin
    float influence = 0;
    float kill2 = 0;
    NodeIndex node_count = 0;
    std::uint64_t advances = 0;
    std::vector<Pull> pulls;
  };
  struct Node {
    Vec3 position{0};
    Tree tree = 0;
    NodeIndex index = 0;    // within its tree
    std::uint32_t sum = 0;  // its place in sums_ plus one while they are gathered, else 0
  };
  struct Sum {
    std::uint32_t node;
    std::int64_t x, y, z;
  };

  void take_new_nodes(Progress& progress);
  void gather_pulls(NodeIndex first_new, bool kills);
  void add_pull(std::uint32_t node, Vec3 point);

  Vec3 origin_{0};
  std::vector<Member> trees_;
  std::vector<Vec3> points_;  // until the first round
  std::optional<NearestNodes> nearest_;
  std::vector<Node> nodes_;
  std::vector<Node> new_nodes_;
  std::vector<Sum> sums_;
};

}  // namespace meristem
