// SPDX-License-Identifier: Apache-2.0
// Growth of colonizing trees. In one step, every node that attraction points pull gets a child. Before the next round,
// the cloud removes the points that the children have reached. Growth is computed relative to the root, which keeps
// precision far from the world's origin; the finished skeleton is moved to its position.
//
// Two deviations from the source ensure that growth ends. First, a child at the position of an existing child is
// rotated at random; points balanced on both sides would otherwise pull a node in one direction forever. The rotation
// grows with each attempt, up to kMaxTurns times. Second, growth stops after kBarrenSteps steps in which no point was
// removed or came nearer to the tree.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/grow/colonize/approach.h"
#include "meristem/grow/colonize/attraction_cloud.h"
#include "meristem/grow/colonize/child_positions.h"
#include "meristem/grow/colonize/colonize.h"
#include "meristem/grow/colonize/colonize_trace.h"
#include "meristem/grow/colonize/colonizing_species.h"
#include "meristem/grow/colonize/growth_direction.h"
#include "meristem/grow/stand_space.h"
#include "meristem/plant/finish.h"
#include "meristem/plant/join_skeletons.h"
#include "meristem/scene/obstacle/open_way.h"

namespace meristem {
namespace {

constexpr std::size_t kTreesAtOnce = 4;
constexpr int kBarrenSteps = 30;
constexpr int kMaxTurns = 4;
// Length of the random vector that is added to the unit direction at a node's first turn; doubled at its second turn,
// and so on. Without turns, a tree of 900 points and 6,200 nodes leaves 56 points unreached; with them it reaches all
// points with 3 % more nodes. A value of 0.25 makes three times as many narrow forks.
constexpr double kTurn = 1;

void check_parameters(const ColonizeParameters& parameters) {
  const auto is_positive = [](double value) { return value > 0; };
  if (!is_positive(parameters.step) || !std::isfinite(parameters.step) || !is_positive(parameters.influence) ||
      !is_positive(parameters.kill) || parameters.iterations < 0) {
    throw std::invalid_argument("colonize: step, influence and kill distance must be above 0, iterations at least 0");
  }
}

/// One tree, relative to its root.
class Tree {
 public:
  Tree(const ColonizingSpecies& species, AttractionCloud& cloud, StandSpace& space, const Seedling& seedling,
       RandomKey key)
      : species_(&species),
        cloud_(&cloud),
        space_(&space),
        key_(key),
        member_(cloud.join(seedling.root, seedling.points, attraction(species.parameters), species.scene,
                           species.felt_shade)),
        root_(seedling.root),
        places_(species.parameters.step) {
    note_node(kNoNode, Vec3(0));
  }

  /// Grows one step and returns true if the tree may grow further. Only reads the cloud, so trees may step in parallel.
  bool step();
  /// Reports the nodes of the step to the cloud and the space.
  void tell();
  Skeleton take_skeleton() { return std::move(skeleton_); }
  const Skeleton& skeleton() const { return skeleton_; }
  AttractionCloud::Tree member() const { return member_; }
  Vec3 root() const { return root_; }

 private:
  static Attraction attraction(const ColonizeParameters& parameters) {
    return {parameters.influence, parameters.kill, parameters.light, parameters.directions};
  }
  bool start_approach();
  bool grow_toward_cloud();
  bool grow_into_cloud(std::span<const Pull> pulls);
  std::optional<Vec3> place_child(const Pull& pull);
  DVec3 bias_at(NodeIndex node) const;
  bool is_open(Vec3 from, Vec3 to) const { return is_way_open(species_->scene.obstacles, root_, from, to); }
  void add_node(NodeIndex parent, Vec3 position);
  void note_node(NodeIndex parent, Vec3 position);

  const ColonizingSpecies* species_;
  AttractionCloud* cloud_;
  StandSpace* space_;
  RandomKey key_;
  AttractionCloud::Tree member_;
  Vec3 root_;
  Skeleton skeleton_;
  NodeIndex told_ = 1;  // number of reported nodes; the root is known from the start
  ChildPositions places_;
  std::vector<std::uint8_t> turns_;  // by node
  Approach approach_;
  std::uint64_t approach_steps_left_ = 0;
  int steps_ = 0;
  int barren_steps_ = 0;
};

bool Tree::step() {
  const std::span<const Pull> pulls = cloud_->pulls(member_);
  const bool is_first = steps_++ == 0;
  if (!pulls.empty()) return grow_into_cloud(pulls);
  if (is_first && !start_approach()) return false;
  return grow_toward_cloud();
}

/// Plans the stem to the cloud. Returns false if there is no point to grow to.
bool Tree::start_approach() {
  const ColonizeParameters& parameters = species_->parameters;
  const std::optional<Vec3> target = cloud_->nearest_point(member_);
  if (!target) return false;
  approach_ = plan_approach(*target, parameters.step, parameters.influence);
  // Growth may end before the stem reaches the crown; the limit then applies to the nodes that will be made.
  species_->require_nodes(std::min(approach_.steps, static_cast<std::uint64_t>(parameters.iterations)), "step");
  // One more step, in case rounding leaves the point just outside.
  approach_steps_left_ = approach_.steps + 1;
  return true;
}

bool Tree::grow_toward_cloud() {
  if (approach_steps_left_ == 0) return false;
  --approach_steps_left_;
  const auto last = static_cast<NodeIndex>(skeleton_.node_count() - 1);
  const Vec3 point(approach_.direction * (species_->parameters.step * (last + 1.0)));
  if (!is_open(skeleton_.position[last], point)) {
    const Vec3 wall = root_ + point;
    species_->refuse("crown",
                     fmt::format("an obstacle stands between a root and its crown, at ({:.4g}, {:.4g}, {:.4g})", wall.x,
                                 wall.y, wall.z),
                     "a root that reaches its crown in a straight line");
  }
  add_node(last, point);
  return true;
}

bool Tree::grow_into_cloud(std::span<const Pull> pulls) {
  approach_steps_left_ = 0;
  barren_steps_ = cloud_->has_advanced(member_) ? 0 : barren_steps_ + 1;
  if (barren_steps_ > kBarrenSteps) return false;
  for (const Pull& pull : pulls) {
    const std::optional<Vec3> point = place_child(pull);
    if (point && is_open(skeleton_.position[pull.node], *point)) add_node(pull.node, *point);
  }
  return true;
}

/// Returns the vector that is added to the pull of a node's points.
DVec3 Tree::bias_at(NodeIndex node) const {
  const Directions& directions = species_->parameters.directions;
  const Vec3 position = root_ + skeleton_.position[node];
  const Vec3 given = directions.light_sense().given_at(position) + directions.gravity_sense().given_at(position);
  return DVec3(species_->parameters.bias) + DVec3(given);
}

std::optional<Vec3> Tree::place_child(const Pull& pull) {
  const double step = species_->parameters.step;
  const DVec3 from(skeleton_.position[pull.node]);
  const std::optional<DVec3> direction = growth_direction(pull.sum, bias_at(pull.node));
  if (direction) {
    const Vec3 point(from + step * *direction);
    if (places_.is_free(skeleton_, pull.node, point)) return point;
  }
  // Rotate the blocked direction, or skip the node in this step.
  if (turns_[pull.node] == kMaxTurns) return std::nullopt;
  const int turn = ++turns_[pull.node];
  const DVec3 random(key_.child(pull.node).direction(static_cast<std::uint64_t>(turn)));
  const DVec3 turned = direction.value_or(DVec3(0)) + kTurn * turn * random;
  const double length = std::sqrt(glm::dot(turned, turned));
  if (!(length > 0)) return std::nullopt;
  const Vec3 point(from + step / length * turned);
  return places_.is_free(skeleton_, pull.node, point) ? std::optional(point) : std::nullopt;
}

void Tree::add_node(NodeIndex parent, Vec3 position) {
  species_->require_nodes(cloud_->node_count() + skeleton_.node_count() - told_ + 1, "step");
  note_node(parent, position);
}

void Tree::tell() {
  for (; told_ < skeleton_.node_count(); ++told_) {
    const Vec3 position = skeleton_.position[told_];
    cloud_->add_node(member_, position);
    if (space_->is_felt()) space_->grow_shoot(root_ + position, species_->parameters.step);
    species_->require_nodes(cloud_->node_count(), "step");
  }
}

void Tree::note_node(NodeIndex parent, Vec3 position) {
  skeleton_.add_node(parent, position, static_cast<float>(steps_));
  places_.add_node(parent);
  turns_.push_back(0);
}

class Colonizer : public Grower {
 public:
  Colonizer(Stand& stand, std::vector<Seedling> seedlings, const ColonizeParameters& parameters, RandomKey key,
            const Scene& scene, const SizeLimits& limits, std::string component, const Progress& progress)
      : species_{parameters, scene, limits, std::move(component)}, cloud_(cloud_of(stand)) {
    leave_out_inner_points(seedlings, progress);
    if (records_points()) cloud_.keep_record();
    auto& space = stand.commons<StandSpace>();
    if (const auto& response = species_.parameters.light.shade) {
      species_.felt_shade = &space.shade(form_of(*response), limits.mesh_bytes, species_.path("light.shade.voxel"));
    }
    trees_.reserve(seedlings.size());
    for (std::size_t k = 0; k < seedlings.size(); ++k) {
      check_points(cloud_.point_count() + seedlings[k].points.size());
      trees_.emplace_back(species_, cloud_, space, seedlings[k], key.child("tree").child(k));
    }
    grows_.assign(trees_.size(), 1);
  }

  int step_limit() const override { return species_.parameters.iterations; }
  bool step(Progress& progress) override;
  void tell() override {
    for (Tree& tree : trees_) tree.tell();
  }
  std::unique_ptr<GrowthTrace> take_trace() override;
  Skeleton take_skeleton(Progress& progress) override;

 private:
  /// Creates the light first, because the pull of points depends on it.
  static AttractionCloud& cloud_of(Stand& stand) {
    stand.commons<StandSpace>();
    return stand.commons<AttractionCloud>();
  }
  /// Returns shade parameters with the direction of the scene's light.
  ShadowParameters form_of(const ShadeResponse& response) const {
    ShadowParameters form = response.form;
    form.toward_light = species_.scene.light.mean_direction();
    return form;
  }
  void check_points(std::uint64_t points) const {
    if (points <= species_.limits.points) return;
    throw_limit("attraction points", static_cast<double>(points), species_.limits.points, "points",
                species_.path("points"));
  }
  bool records_points() const {
    const TraceRequest request = species_.parameters.request;
    return request.has(TracePart::points) || request.has(TracePart::pulls);
  }
  void require_record() const;
  void leave_out_inner_points(std::vector<Seedling>& seedlings, const Progress& progress);

  ColonizingSpecies species_;
  AttractionCloud& cloud_;
  std::vector<std::vector<Vec3>> inner_points_;  // by tree: points removed by obstacles, if points are recorded
  std::vector<Tree> trees_;
  std::vector<std::uint8_t> grows_;  // by tree; bytes, so that each thread can write its own
  int steps_ = 0;                    // number of steps begun
};

/// Limits the memory of recorded moving points.
void Colonizer::require_record() const {
  if (!records_points() || cloud_.record_bytes() <= species_.limits.mesh_bytes) return;
  throw_limit("bytes of attraction points that are recorded step by step", static_cast<double>(cloud_.record_bytes()),
              species_.limits.mesh_bytes, "mesh_bytes", species_.path("iterations"));
}

bool Colonizer::step(Progress& progress) {
  progress.check();
  ++steps_;
  require_record();
  parallel_for(trees_.size(), kTreesAtOnce, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t k = begin; k < end; ++k) {
      if (grows_[k] != 0) grows_[k] = trees_[k].step() ? 1 : 0;
    }
  });
  return std::ranges::count(grows_, 0) < static_cast<std::ptrdiff_t>(grows_.size());
}

/// Removes the points inside obstacles.
void Colonizer::leave_out_inner_points(std::vector<Seedling>& seedlings, const Progress& progress) {
  const Obstacles& obstacles = species_.scene.obstacles;
  inner_points_.resize(seedlings.size());
  if (obstacles.empty()) return;
  for (Seedling& seedling : seedlings) {
    if (obstacles.contain(seedling.root)) {
      species_.refuse("roots",
                      fmt::format("a root stands inside an obstacle, at ({:.4g}, {:.4g}, {:.4g})", seedling.root.x,
                                  seedling.root.y, seedling.root.z),
                      "a position outside all of scene.obstacles");
    }
    if (seedling.points.empty()) continue;
    const std::vector<std::uint8_t> is_inner = inside_of(obstacles, seedling.points, progress);
    std::vector<Vec3>& inner = inner_points_[static_cast<std::size_t>(&seedling - seedlings.data())];
    std::size_t k = 0;
    std::erase_if(seedling.points, [&](Vec3 point) {
      const bool goes = is_inner[k++] != 0;
      if (goes && records_points()) inner.push_back(point);
      return goes;
    });
    if (seedling.points.empty()) {
      species_.refuse("crown", "the crown lies wholly inside obstacles", "a crown that reaches out of scene.obstacles");
    }
  }
}

std::unique_ptr<GrowthTrace> Colonizer::take_trace() {
  if (!species_.parameters.request.has(TracePart::steps) && !records_points()) return nullptr;
  std::vector<TracedTree> trees;
  for (std::size_t k = 0; k < trees_.size(); ++k) {
    TracedTree& tree = trees.emplace_back(TracedTree{trees_[k].root(), trees_[k].skeleton(), {}, cloud_.origin()});
    if (!records_points()) continue;
    for (const Vec3 point : inner_points_[k]) {
      tree.points.points.push_back({.position = point - cloud_.origin(), .is_removed = true});
    }
    const std::vector<PointHistory::Point>& own = cloud_.histories()[trees_[k].member()].points;
    tree.points.points.insert(tree.points.points.end(), own.begin(), own.end());
  }
  return std::make_unique<ColonizeTrace>(species_, std::move(trees), steps_);
}

Skeleton Colonizer::take_skeleton(Progress& progress) {
  std::vector<Skeleton> finished(trees_.size());
  parallel_for(trees_.size(), kTreesAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      progress.check();
      finished[k] = finished_tree(species_, trees_[k].take_skeleton(), trees_[k].root(), progress);
    }
  });
  return join_skeletons(std::move(finished));
}

}  // namespace

std::unique_ptr<Grower> make_colonizer(Stand& stand, std::vector<Seedling> seedlings,
                                       const ColonizeParameters& parameters, RandomKey key, const Scene& scene,
                                       const SizeLimits& limits, std::string component, const Progress& progress) {
  check_parameters(parameters);
  return std::make_unique<Colonizer>(stand, std::move(seedlings), parameters, key, scene, limits, std::move(component),
                                     progress);
}

}  // namespace meristem
