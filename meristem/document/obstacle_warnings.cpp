// SPDX-License-Identifier: Apache-2.0
// Stems are tested by segments, so thin obstacles are not missed. Shapes that are drawn around a path, such as horns,
// are tested at some of their vertices; a wall that is thinner than their distance may be missed.
#include "meristem/document/obstacle_warnings.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr std::size_t kSegmentsAtOnce = 1024;
constexpr std::size_t kMaxVertices = 64;  // largest number of vertices that are tested per organ
// Metres at the start of a stem's first segment that are not tested: the root may stand on an obstacle
constexpr float kOffTheGround = 0.01F;

/// Counts of a component's pieces that were tested, and of the pieces that lie in obstacles.
struct Tally {
  const Prototype* component = nullptr;
  const char* pieces = "";  ///< what is counted
  std::uint64_t all = 0, inside = 0;
  std::optional<Vec3> first;

  void add(bool is_inside, Vec3 position) {
    ++all;
    if (!is_inside) return;
    ++inside;
    if (!first) first = position;
  }
};

bool meet(const Box& a, const Box& b) {
  return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

/// Returns the components that draw stems without growth.
std::vector<const Prototype*> drawn_components(const Graph& graph) {
  std::vector<const Prototype*> drawn;
  for (const Prototype& prototype : graph.components) {
    if (prototype.type->makes_stems && !prototype.type->grow) drawn.push_back(&prototype);
  }
  return drawn;
}

class Looker {
 public:
  Looker(const Graph& graph, const Obstacles& obstacles, const Plant& plant, const Progress& progress)
      : obstacles_(obstacles), bounds_(obstacles.bounds()), plant_(plant), progress_(progress) {
    for (const Prototype* component : drawn_components(graph)) {
      by_id_.emplace(component->id, tallies_.size());
      tallies_.push_back({.component = component, .pieces = "segments"});
      tallies_.push_back({.component = component, .pieces = "points of its surface"});
    }
  }

  std::vector<Diagnostic> run() {
    if (tallies_.empty()) return {};
    for (const Stem& stem : plant_.stems) look_at(stem);
    for (const Organ& organ : plant_.organs) look_at(organ);
    std::vector<Diagnostic> warnings;
    for (const Tally& tally : tallies_) {
      if (!tally.first) continue;
      warnings.push_back({.severity = Severity::warning,
                          .message = fmt::format("'{}' does not avoid obstacles and goes into them with {} of its {} "
                                                 "{}, first at ({:.3g}, {:.3g}, {:.3g})",
                                                 tally.component->id, tally.inside, tally.all, tally.pieces,
                                                 tally.first->x, tally.first->y, tally.first->z),
                          .path = "components." + tally.component->id});
    }
    return warnings;
  }

 private:
  /// Returns the index of the component's first tally, or nothing for a component that draws no stems.
  std::optional<std::size_t> tally_of(const std::string& component) const {
    const auto found = by_id_.find(component);
    return found == by_id_.end() ? std::nullopt : std::optional(found->second);
  }

  void look_at(const Stem& stem) {
    const Skeleton& skeleton = stem.skeleton;
    std::vector<std::optional<std::size_t>> of_part;
    for (const StemPart& part : stem.parts) of_part.push_back(tally_of(part.component));
    if (std::ranges::none_of(of_part, [](const auto& found) { return found.has_value(); })) return;
    std::vector<std::uint8_t> is_inside(skeleton.node_count(), 0);
    parallel_for(skeleton.node_count(), kSegmentsAtOnce, [&](std::size_t begin, std::size_t end) {
      progress_.check();
      for (std::size_t node = begin; node < end; ++node) is_inside[node] = is_segment_inside(skeleton, node) ? 1 : 0;
    });
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      if (skeleton.is_root(node)) continue;
      const auto tally = of_part[stem.part_index(skeleton.axis[node])];
      if (tally) tallies_[*tally].add(is_inside[node] != 0, skeleton.position[node]);
    }
  }

  bool is_segment_inside(const Skeleton& skeleton, std::size_t node) const {
    if (skeleton.is_root(static_cast<NodeIndex>(node))) return false;
    const NodeIndex parent = skeleton.parent[node];
    const Vec3 to = skeleton.position[node];
    Vec3 from = skeleton.position[parent];
    if (skeleton.is_root(parent)) from = glm::mix(from, to, kOffTheGround);
    Box box;
    box.add(from);
    box.add(to);
    return meet(box, bounds_) && (obstacles_.cross(from, to) || obstacles_.contain(to));
  }

  void look_at(const Organ& organ) {
    const OrganPrototype& prototype = plant_.prototypes[organ.prototype];
    const auto tally = tally_of(prototype.component);
    if (!tally || prototype.mesh->positions.empty()) return;
    const std::vector<Vec3>& all = prototype.mesh->positions;
    const std::size_t step = (all.size() + kMaxVertices - 1) / kMaxVertices;
    progress_.check();
    for (std::size_t k = 0; k < all.size(); k += step) {
      const Vec3 position = organ.frame.point(all[k]);
      tallies_[*tally + 1].add(bounds_.holds(position) && obstacles_.contain(position), position);
    }
  }

  const Obstacles& obstacles_;
  const Box bounds_;
  const Plant& plant_;
  const Progress& progress_;
  std::vector<Tally> tallies_;  // two per component: its stems, and its other drawn pieces
  std::unordered_map<std::string, std::size_t> by_id_;
};

}  // namespace

std::vector<Diagnostic> obstacle_warnings(const Graph& graph, const Obstacles& obstacles, const Plant& plant,
                                          const Progress& progress) {
  if (obstacles.empty()) return {};
  return Looker(graph, obstacles, plant, progress).run();
}

}  // namespace meristem
