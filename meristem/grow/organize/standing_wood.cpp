// SPDX-License-Identifier: Apache-2.0
// Converts a skeleton to metamers in one pass from the root. A node with several laterals becomes a chain of short
// metamers, because a metamer has one lateral bud.
#include "meristem/grow/organize/standing_wood.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/math.h"
#include "meristem/plant/finish.h"
#include "meristem/plant/further_columns.h"
#include "meristem/plant/shed.h"

namespace meristem {

namespace {

constexpr double kStub = 0.04;       // length of metamers that only bear a lateral, as a share of a metamer's length
constexpr double kStubShare = 0.25;  // largest share of an internode that all of them take

double internode(const Skeleton& wood, NodeIndex node) {
  return glm::distance(DVec3(wood.position[node]), DVec3(wood.position[wood.parent[node]]));
}

/// Returns the number of metamers for a length in metres.
double pieces_of(double way, double length) { return std::max(1.0, std::floor(way / length + 0.5)); }

class Planting {
 public:
  Planting(const Skeleton& wood, double length, bool has_metamers)
      : wood_(wood), length_(length), has_metamers_(has_metamers), forks_(wood.node_count()) {
    for (NodeIndex node = 1; node < wood.node_count(); ++node) {
      Fork& fork = forks_[wood.parent[node]];
      ++fork.laterals;
      // In a skeleton of metamers, the axes define which bud has grown into each metamer.
      if (has_metamers && wood.parent[node] != 0 && wood.axis[node] != wood.axis[wood.parent[node]]) continue;
      if (fork.successor == kNoNode || goes_on_before(node, fork.successor)) fork.successor = node;
    }
    for (Fork& fork : forks_) {
      if (fork.successor != kNoNode) --fork.laterals;
    }
  }

  std::vector<WoodMetamer> metamers() {
    if (wood_.node_count() > 0) arrive(0, 0);
    for (NodeIndex node = 1; node < wood_.node_count(); ++node) {
      Fork& fork = forks_[wood_.parent[node]];
      const bool is_lateral = fork.successor != node;
      const MetamerIndex from = is_lateral ? next_bearer(fork) : fork.last;
      arrive(node, grow(from, is_lateral, node));
    }
    return std::move(made_);
  }

 private:
  struct Fork {
    NodeIndex successor = kNoNode;  // grows from the terminal bud
    std::uint32_t laterals = 0;     // number of laterals still to be planted
    MetamerIndex first = 0;         // first metamer that bears a lateral
    MetamerIndex first_stub = 0;    // bears the second lateral, if any
    MetamerIndex last = 0;          // bears the successor
    std::uint32_t planted = 0;      // number of planted laterals
  };

  /// Returns true if a node continues its parent's axis rather than `other`, an earlier sibling.
  bool goes_on_before(NodeIndex node, NodeIndex other) const {
    const AxisIndex axis = wood_.axis[wood_.parent[node]];
    const bool is_on_axis = wood_.axis[node] == axis, is_other_on_axis = wood_.axis[other] == axis;
    if (is_on_axis != is_other_on_axis) return is_on_axis;
    return wood_.radius[node] > wood_.radius[other];
  }

  Vec3 tip(MetamerIndex metamer) const { return metamer == 0 ? Vec3(0) : made_[metamer - 1].tip; }
  float radius(MetamerIndex metamer) const { return metamer == 0 ? wood_.radius[0] : made_[metamer - 1].radius; }
  MetamerIndex add(const WoodMetamer& metamer) {
    made_.push_back(metamer);
    return static_cast<MetamerIndex>(made_.size());
  }

  /// Called when the metamer at a node exists. Makes the metamers that bear the node's further laterals.
  void arrive(NodeIndex node, MetamerIndex metamer) {
    Fork& fork = forks_[node];
    const bool has_bud = metamer != 0;  // the seed has no lateral bud
    fork.first = metamer;
    fork.first_stub = static_cast<MetamerIndex>(made_.size() + 1);
    if (!has_bud) fork.first = fork.first_stub++;
    fork.last = metamer;
    const std::uint32_t own = has_bud ? 1 : 0;
    if (fork.laterals <= own) return;
    const std::uint32_t stubs = fork.laterals - own;
    const Vec3 way = fork.successor == kNoNode ? Vec3(0) : wood_.position[fork.successor] - wood_.position[node];
    const double far = glm::length(DVec3(way));
    const double step = far > 0 ? std::min(kStub * length_, kStubShare * far / stubs) / far : 0;
    for (std::uint32_t k = 1; k <= stubs; ++k) {
      fork.last = add({.from = fork.last,
                       .is_lateral = false,
                       .tip = wood_.position[node] + static_cast<float>(step * k) * way,
                       .radius = wood_.radius[node]});
    }
  }

  static MetamerIndex next_bearer(Fork& fork) {
    const std::uint32_t number = fork.planted++;
    return number == 0 ? fork.first : fork.first_stub + number - 1;
  }

  /// Makes the metamers from one metamer to a node.
  MetamerIndex grow(MetamerIndex from, bool is_lateral, NodeIndex node) {
    const Vec3 begin = tip(from), end = wood_.position[node];
    const float thick = is_lateral ? wood_.radius[node] : radius(from);
    const double pieces = has_metamers_ ? 1 : pieces_of(glm::distance(DVec3(begin), DVec3(end)), length_);
    for (double k = 1; k <= pieces; ++k) {
      const auto along = static_cast<float>(k / pieces);
      from = add({.from = from,
                  .is_lateral = is_lateral && k == 1,
                  .tip = k == pieces ? end : glm::mix(begin, end, along),
                  .radius = std::lerp(thick, wood_.radius[node], along),  // exact for equal ends, and monotonic
                  .node = k == pieces ? node : kNoNode});
    }
    return from;
  }

  const Skeleton& wood_;
  double length_;
  bool has_metamers_;
  std::vector<Fork> forks_;  // by node
  std::vector<WoodMetamer> made_;
};

}  // namespace

std::vector<WoodMetamer> metamers_of_wood(const Skeleton& wood, double length) {
  if (wood.extra.contains(kBudAngleColumn)) return Planting(wood, length, true).metamers();
  std::vector<WoodMetamer> metamers = Planting(decimate(wood, length, 0), length, false).metamers();
  // The nodes belong to the thinned skeleton, whose columns have no states of buds.
  for (WoodMetamer& metamer : metamers) metamer.node = kNoNode;
  return metamers;
}

double max_metamers_of_wood(const Skeleton& wood, double length) {
  double metamers = 0;
  for (NodeIndex node = 1; node < wood.node_count(); ++node) {
    metamers += 1 + pieces_of(internode(wood, node), length);  // plus at most one that bears it
  }
  return metamers;
}

void StandingWood::stand(const Metamers& metamers, float seed_radius, const std::vector<WoodMetamer>& wood) {
  radius_.assign(1, seed_radius);
  for (const WoodMetamer& metamer : wood) radius_.push_back(metamer.radius);
  const std::vector<double> tips = count_tips(metamers.parent, {});
  tips_.assign(tips.begin(), tips.end());
}

void StandingWood::remove(const std::vector<std::uint8_t>& gone) {
  erase_marked(radius_, gone);
  erase_marked(tips_, gone);
}

double StandingWood::radius(MetamerIndex metamer, double tips, const PipeModel& model) const {
  const auto stood = static_cast<double>(radius_[metamer]);
  const double gained = tips - static_cast<double>(tips_[metamer]);
  if (!(gained > 0)) return stood;
  const double of_tip = math::pow(model.tip_radius, model.exponent);
  return math::pow(math::pow(stood, model.exponent) + gained * of_tip, 1 / model.exponent);
}

void StandingWood::thicken(Skeleton& skeleton, const PipeModel& model) const {
  if (radius_.empty()) return;
  const auto lost = skeleton.extra.find(kShedColumn);
  const std::span<const float> lost_tips = lost == skeleton.extra.end() ? std::span<const float>() : lost->second;
  const std::vector<double> tips = count_tips(skeleton.parent, lost_tips, model.memory);
  for (MetamerIndex node = 0; node < radius_.size(); ++node) {
    skeleton.radius[node] = static_cast<float>(radius(node, tips[node], model));
  }
  // Wood is at least as thick as everything that it bears, unless it was measured otherwise.
  for (std::size_t node = skeleton.node_count(); node-- > 1;) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent >= radius_.size() || (node < radius_.size() && radius_[node] > radius_[parent])) continue;
    skeleton.radius[parent] = std::max(skeleton.radius[parent], skeleton.radius[node]);
  }
}

}  // namespace meristem
