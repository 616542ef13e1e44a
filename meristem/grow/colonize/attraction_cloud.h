// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/grow/colonize/cloud_motion.h"
#include "meristem/grow/colonize/cloud_record.h"
#include "meristem/grow/colonize/light_response.h"
#include "meristem/grow/colonize/moving_points.h"
#include "meristem/grow/colonize/nearest_nodes.h"
#include "meristem/grow/stand.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// What the points of one node pull it toward.
struct Pull {
  NodeIndex node = 0;  ///< counted within its tree
  DVec3 sum{0};        ///< of the unit vectors from the node to its points
};

/// What points are to a tree.
struct Attraction {
  double influence = 0;  ///< metres within which they pull its nodes, above 0, may be infinite
  double kill = 0;       ///< metres within which its nodes use them up, above 0
  LightResponse light;   ///< of the points that it brings
};

/// The attraction points of all trees of a stand, which compete for them: a point belongs to the nearest node within
/// its tree's influence distance, whichever tree brought the point, and is used up when that node is within its tree's
/// kill distance. The points that a tree brings may lose those in the deepest shade before growth, and may move with
/// the light that falls on the nodes which they pull, whichever trees those belong to; a point that has moved into an
/// obstacle rests while it is there. Positions are relative to the first tree's root, so that a stand far from the
/// world's origin loses no digits; each tree speaks of positions relative to its own root.
class AttractionCloud : public Commons {
 public:
  using Tree = std::uint32_t;

  /// A tree with its root at `root` (world space) that brings `points` (world space); its root is its node 0. Points do
  /// not pull it while they are darker in `shade`, where given, than its response says. `scene` is the same for all;
  /// both outlive the cloud. To be called before the first round.
  Tree join(Vec3 root, const std::vector<Vec3>& points, const Attraction& attraction, const Scene& scene,
            const ShadowGrid* shade = nullptr);
  /// From now on it notes what becomes of its points, for histories(). To be called before the first round.
  void keep_record() { record_.emplace(); }
  /// A new node of a tree; its points are counted from the next round on.
  void add_node(Tree tree, Vec3 position);

  /// Which of a tree's nodes are pulled in this round and where to, by rising index. Sums are of whole numbers (unit
  /// vectors in steps of 2^-38), so they do not depend on the order of the points.
  std::span<const Pull> pulls(Tree tree) const { return trees_[tree].pulls; }
  /// Whether the tree's nodes used up a point or came nearer to one: its newest nodes or, where points move, the
  /// nearest of all.
  bool has_advanced(Tree tree) const { return trees_[tree].advances > 0; }
  /// The point to which a tree should grow that none pulls yet: in the first round the nearest of those that it
  /// brought, where it brought none the living one nearest to its root. Costs as much as a search in a tree of points.
  std::optional<Vec3> nearest_point(Tree tree) const;

  std::uint64_t node_count() const { return nodes_.size() + new_nodes_.size(); }
  std::uint64_t point_count() const { return still_ ? still_->living() : moving_ ? moving_->living() : points_.size(); }

  void begin_round(Progress& progress) override;
  void end_record(Progress& progress) override;
  /// What has become of the points of each tree, after end_record(); relative to origin().
  const std::vector<PointHistory>& histories() const { return histories_; }
  Vec3 origin() const { return origin_; }  ///< world space
  std::uint64_t record_bytes() const { return record_ ? record_->bytes() : 0; }

 private:
  struct Member {
    Vec3 offset{0};  // its root relative to the cloud's origin
    Attraction attraction;
    const ShadowGrid* shade = nullptr;
    float kill2 = 0;
    std::size_t points = 0;           // that it brought; those of all trees stand one after another
    std::optional<Vec3> nearest_own;  // of these, relative to its root
    // Squared distances between moving points and nodes: the least at the last advance, and the least of this round.
    float closest2 = std::numeric_limits<float>::infinity();
    float now_closest2 = std::numeric_limits<float>::infinity();
    NodeIndex node_count = 0;
    std::uint64_t advances = 0;
    std::vector<Pull> pulls;
  };
  struct Node {
    Vec3 position{0};
    Tree tree = 0;
    NodeIndex index = 0;    // within its tree
    std::uint32_t sum = 0;  // its index in sums_ plus one while they are gathered, else 0
    float kill2 = 0;        // of its tree, so that points need not look there
  };
  struct Sum {
    std::uint32_t node;
    std::int64_t x, y, z;
  };

  void plant_points(Progress& progress);
  void record_points();
  void record_removed(Tree tree, std::span<const Vec3> points, std::span<const std::uint32_t> left);
  void leave_out_darkest(const Progress& progress);
  void start_moving();
  bool is_too_dark(const Member& member, Vec3 point) const;
  void take_new_nodes(Progress& progress);
  void gather_still(NodeIndex first_new, bool kills);
  void gather_moving(bool kills, const Progress& progress);
  void use_up_moving(bool kills);
  static void note_closeness(Member& member);
  void hand_over_pulls();
  void add_pull(std::uint32_t node, Vec3 point);

  const Scene* scene_ = nullptr;
  Vec3 origin_{0};
  bool any_feels_shade_ = false;
  std::vector<Member> trees_;
  std::vector<Vec3> points_;  // until the first round; from then on they are in one of these
  std::optional<NearestNodes> still_;
  std::optional<MovingPoints> moving_;
  std::optional<CloudMotion> motion_;
  std::vector<Node> nodes_;
  std::vector<Node> new_nodes_;
  std::vector<Sum> sums_;
  std::optional<CloudRecord> record_;  // where one is kept
  std::vector<PointHistory> histories_;
};

}  // namespace meristem
