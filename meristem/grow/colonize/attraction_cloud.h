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

/// The pull of all points of one node.
struct Pull {
  NodeIndex node = 0;  ///< index within its tree
  DVec3 sum{0};        ///< sum of the unit vectors from the node to its points
};

/// The attraction parameters of a tree.
struct Attraction {
  double influence = 0;     ///< metres within which points pull its nodes; above 0, may be infinite
  double kill = 0;          ///< metres within which its nodes use up points; above 0
  LightResponse light;      ///< light response of the points that it brings
  Directions directions{};  ///< fields that may carry these points
};

/// The attraction points of all trees of a stand, which compete for them. A point belongs to the nearest node within
/// the influence distance of that node's tree, whichever tree brought the point. It is used up when the node is within
/// its tree's kill distance. The points of a tree may lose those in the deepest shade before growth. They may also move
/// with the light on the nodes that they pull, whichever trees these nodes belong to. A point that has moved into an
/// obstacle is inactive while it is there. Positions in the cloud are relative to the first tree's root, which keeps
/// precision far from the world's origin. Each tree uses positions relative to its own root.
class AttractionCloud : public StandCommons {
 public:
  using Tree = std::uint32_t;

  /// Adds a tree with its root at `root` (world space) that brings `points` (world space). The root is node 0. If
  /// `shade` is not null, points do not pull the tree while they are darker than its response allows. `scene` must be
  /// the same for all trees; `scene` and `shade` must outlive the cloud. Call it before the first round.
  Tree join(Vec3 root, const std::vector<Vec3>& points, const Attraction& attraction, const Scene& scene,
            const ShadowGrid* shade = nullptr);
  /// Records the history of all points for histories(). Call it before the first round.
  void keep_record() { record_.emplace(); }
  /// Adds a node to a tree. It takes effect in the next round.
  void add_node(Tree tree, Vec3 position);

  /// Returns the nodes of a tree that are pulled in this round, with their pulls, in rising order. Sums use whole
  /// numbers (unit vectors in steps of 2^-38), so they do not depend on the order of the points.
  std::span<const Pull> pulls(Tree tree) const { return trees_[tree].pulls; }
  /// Returns true if the tree used up a point or came nearer to one. For points at rest, only the newest nodes count;
  /// for moving points, the nearest node counts.
  bool has_advanced(Tree tree) const { return trees_[tree].advances > 0; }
  /// Returns the point to which a tree without pulls should grow. In the first round, this is the nearest of its own
  /// points. If it brought no points, it is the living point nearest to its root. Cost: one search in a tree of points.
  std::optional<Vec3> nearest_point(Tree tree) const;

  std::uint64_t node_count() const { return nodes_.size() + new_nodes_.size(); }
  std::uint64_t point_count() const { return still_ ? still_->living() : moving_ ? moving_->living() : points_.size(); }

  void begin_round(Progress& progress) override;
  void end_record(Progress& progress) override;
  /// Returns the history of the points of each tree, relative to origin(). Valid after end_record().
  const std::vector<PointHistory>& histories() const { return histories_; }
  Vec3 origin() const { return origin_; }  ///< world space
  std::uint64_t record_bytes() const { return record_ ? record_->bytes() : 0; }

 private:
  struct Member {
    Vec3 offset{0};  // its root relative to the cloud's origin
    Attraction attraction;
    const ShadowGrid* shade = nullptr;
    float kill2 = 0;
    std::size_t points = 0;           // number of points that it brought; stored tree after tree
    std::optional<Vec3> nearest_own;  // nearest of these points, relative to its root
    // Squared distances between moving points and nodes: the smallest at the last advance, and the smallest of this
    // round.
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
    std::uint32_t sum = 0;  // while sums are gathered, its index in sums_ plus one; else 0
    float kill2 = 0;        // copy of its tree's value, for faster access
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
  std::vector<Vec3> points_;  // used until the first round; then one of the next two members
  std::optional<NearestNodes> still_;
  std::optional<MovingPoints> moving_;
  std::optional<CloudMotion> motion_;
  std::vector<Node> nodes_;
  std::vector<Node> new_nodes_;
  std::vector<Sum> sums_;
  std::optional<CloudRecord> record_;  // set if a record is kept
  std::vector<PointHistory> histories_;
};

}  // namespace meristem
