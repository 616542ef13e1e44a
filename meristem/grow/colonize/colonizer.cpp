// SPDX-License-Identifier: Apache-2.0
// One step of growth: sum up what pulls each node, give pulled nodes a child, find the points that the children are
// nearest to, and remove those they have reached. Growth happens relative to the root, so that a tree far from the
// world's origin loses no digits; the finished skeleton is moved to its place.
//
// Deviations, so that growth ends: a child that would stand where its node already has one (points balanced on both
// sides pull a node the same way for ever) is turned by a keyed draw, a little more each time and kMostTurns times at
// most. Growth stops after kBarrenSteps steps in which no point was removed or came nearer to the tree.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/grow/colonize/approach.h"
#include "meristem/grow/colonize/child_places.h"
#include "meristem/grow/colonize/colonize.h"
#include "meristem/grow/colonize/growth_direction.h"
#include "meristem/grow/colonize/nearest_nodes.h"
#include "meristem/plant/finish.h"

namespace meristem {
namespace {

constexpr int kBarrenSteps = 30;
constexpr int kMostTurns = 4;
// Length of the random vector added to the unit direction at a node's first turn; twice that at its second. Without
// turns a tree of 900 points and 6,200 nodes leaves 56 points unreached; with them none, for 3 % more nodes. At 0.25
// three times as many of the new forks are narrow.
constexpr double kTurn = 1;

void check_parameters(const ColonizeParameters& parameters) {
  const auto is_positive = [](double value) { return value > 0; };
  if (!is_positive(parameters.step) || !std::isfinite(parameters.step) || !is_positive(parameters.influence) ||
      !is_positive(parameters.kill) || parameters.iterations < 0) {
    throw std::invalid_argument("colonize: step, influence and kill distance must be above 0, iterations at least 0");
  }
}

class Colonizer : public Grower {
 public:
  Colonizer(Vec3 root, std::vector<Vec3> points, const ColonizeParameters& parameters, RandomKey key,
            const Limits& limits, std::string component)
      : root_(root),
        points_(std::move(points)),
        parameters_(parameters),
        key_(key),
        limits_(limits),
        component_(std::move(component)),
        places_(parameters.step) {}

  int step_limit() const override { return parameters_.iterations; }
  bool step(Progress& progress) override;
  Skeleton take_skeleton(Progress& progress) override;

 private:
  std::string path(const char* parameter) const { return fmt::format("components.{}.{}", component_, parameter); }
  void start(Progress& progress);
  void start_approach();
  bool grow_toward_cloud(Progress& progress);
  bool grow_into_cloud(Progress& progress);
  std::optional<Vec3> place_child(const Pull& pull);
  void add_node(NodeIndex parent, Vec3 position);
  void require_nodes(std::uint64_t nodes, const char* parameter) const;

  Vec3 root_;
  std::vector<Vec3> points_;  // until the first step
  ColonizeParameters parameters_;
  RandomKey key_;
  Limits limits_;
  std::string component_;

  Skeleton skeleton_;  // relative to the root
  ChildPlaces places_;
  std::vector<std::uint8_t> turns_;  // by node
  std::optional<NearestNodes> nearest_;
  PullSums pulls_;
  Approach approach_;
  std::uint64_t approach_steps_left_ = 0;
  int steps_ = 0;
  int barren_steps_ = 0;
};

bool Colonizer::step(Progress& progress) {
  progress.check();
  if (!nearest_) start(progress);
  ++steps_;
  const bool may_grow = approach_steps_left_ > 0 ? grow_toward_cloud(progress) : grow_into_cloud(progress);
  return may_grow && steps_ < parameters_.iterations;
}

void Colonizer::start(Progress& progress) {
  if (points_.size() > limits_.points) {
    throw_limit("attraction points", static_cast<double>(points_.size()), limits_.points, "points", path("points"));
  }
  for (Vec3& point : points_) point -= root_;
  nearest_.emplace(points_, static_cast<float>(parameters_.influence), progress);
  add_node(kNoNode, Vec3(0));
  const std::size_t taken = nearest_->add_nodes(0, skeleton_.position, progress);
  if (taken == 0 && !points_.empty()) start_approach();
  std::vector<Vec3>().swap(points_);
}

void Colonizer::start_approach() {
  approach_ = plan_approach(points_, parameters_.step, parameters_.influence);
  if (approach_.steps >= static_cast<std::uint64_t>(parameters_.iterations)) {
    throw InputError(Diagnostic{
        .message = fmt::format("the crown is out of reach: its nearest point is {:.4g} m from the root, {} steps of "
                               "{:.4g} m before it is within the influence distance of {:.4g} m",
                               approach_.distance, approach_.steps, parameters_.step, parameters_.influence),
        .expected =
            fmt::format("more than {} iterations, a longer step, or a crown nearer to the root", approach_.steps),
        .path = path("iterations")});
  }
  require_nodes(approach_.steps, "step");
  // One more in case rounding keeps the point just outside.
  approach_steps_left_ = approach_.steps + 1;
}

bool Colonizer::grow_toward_cloud(Progress& progress) {
  const auto last = static_cast<NodeIndex>(skeleton_.node_count() - 1);
  require_nodes(last + 2U, "step");
  add_node(last, Vec3(approach_.direction * (parameters_.step * (last + 1.0))));
  const std::size_t taken = nearest_->add_nodes(last + 1, std::span(skeleton_.position).subspan(last + 1), progress);
  --approach_steps_left_;
  if (taken == 0) return approach_steps_left_ > 0;
  approach_steps_left_ = 0;
  return true;
}

bool Colonizer::grow_into_cloud(Progress& progress) {
  const std::span<const Pull> pulls = pulls_.gather(*nearest_, skeleton_.position);
  if (pulls.empty()) return false;
  require_nodes(skeleton_.node_count() + pulls.size(), "step");
  // Give every pulled node a child.
  const std::size_t first = skeleton_.node_count();
  for (const Pull& pull : pulls) {
    if (const std::optional<Vec3> place = place_child(pull)) add_node(pull.node, *place);
  }
  // Let the children take over points, and remove the points that are reached.
  const std::span<const Vec3> children = std::span(skeleton_.position).subspan(first);
  const std::size_t taken = nearest_->add_nodes(static_cast<NodeIndex>(first), children, progress);
  const std::size_t removed = nearest_->remove_within(static_cast<float>(parameters_.kill));
  barren_steps_ = taken + removed > 0 ? 0 : barren_steps_ + 1;
  return barren_steps_ < kBarrenSteps && nearest_->living() > 0;
}

std::optional<Vec3> Colonizer::place_child(const Pull& pull) {
  const DVec3 from(skeleton_.position[pull.node]);
  const std::optional<DVec3> direction = growth_direction(pull, parameters_.bias);
  if (direction) {
    const Vec3 place(from + parameters_.step * *direction);
    if (places_.is_free(skeleton_, pull.node, place)) return place;
  }
  // Turn a direction that leads nowhere, or pass the node by in this step.
  if (turns_[pull.node] == kMostTurns) return std::nullopt;
  const int turn = ++turns_[pull.node];
  const DVec3 random(key_.child(pull.node).direction(static_cast<std::uint64_t>(turn)));
  const DVec3 turned = direction.value_or(DVec3(0)) + kTurn * turn * random;
  const double length = std::sqrt(glm::dot(turned, turned));
  if (!(length > 0)) return std::nullopt;
  const Vec3 place(from + parameters_.step / length * turned);
  return places_.is_free(skeleton_, pull.node, place) ? std::optional(place) : std::nullopt;
}

void Colonizer::add_node(NodeIndex parent, Vec3 position) {
  skeleton_.add_node(parent, position, static_cast<float>(steps_));
  places_.add_node(parent);
  turns_.push_back(0);
}

void Colonizer::require_nodes(std::uint64_t nodes, const char* parameter) const {
  if (nodes <= limits_.nodes) return;
  throw_limit("skeleton nodes", static_cast<double>(nodes), limits_.nodes, "nodes", path(parameter));
}

double total_length(const Skeleton& skeleton) {
  double length = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.is_root(node)) continue;
    length += glm::distance(skeleton.position[node], skeleton.position[skeleton.parent[node]]);
  }
  return length;
}

Skeleton Colonizer::take_skeleton(Progress& progress) {
  if (!nearest_) start(progress);
  nearest_.reset();
  const Finish& finish = parameters_.finish;
  Skeleton skeleton = std::move(skeleton_);
  if (finish.decimate > 0) {
    skeleton = decimate(skeleton, finish.decimate * parameters_.step, parameters_.step);
    progress.check();
  }
  if (finish.relax) relax_angles(skeleton);
  if (finish.subdivide > 0) {
    const double spacing = finish.subdivide * parameters_.step;
    const double nodes = static_cast<double>(skeleton.node_count()) + total_length(skeleton) / spacing;
    require_nodes(static_cast<std::uint64_t>(std::min(nodes, 1e18)), "finish.subdivide");
    skeleton = subdivide(skeleton, spacing);
    progress.check();
  }
  assign_pipe_radii(skeleton, parameters_.radii);
  assign_axes(skeleton);
  for (Vec3& position : skeleton.position) position += root_;
  return skeleton;
}

}  // namespace

std::unique_ptr<Grower> make_colonizer(Vec3 root, std::vector<Vec3> points, const ColonizeParameters& parameters,
                                       RandomKey key, const Limits& limits, std::string component) {
  check_parameters(parameters);
  return std::make_unique<Colonizer>(root, std::move(points), parameters, key, limits, std::move(component));
}

}  // namespace meristem
