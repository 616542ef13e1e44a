// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/colonize_trace.h"

#include <algorithm>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/base/point_tree.h"
#include "meristem/grow/colonize/node_forest.h"
#include "meristem/plant/join_skeletons.h"

namespace meristem {

namespace {

constexpr std::size_t kTracedTreesAtOnce = 4;
constexpr std::size_t kPointsPerCheck = 1024;

/// Returns the number of nodes after a step.
std::size_t count_at(const Skeleton& skeleton, int step) {
  const auto end = std::ranges::upper_bound(skeleton.birth, static_cast<float>(step));
  return static_cast<std::size_t>(end - skeleton.birth.begin());
}

/// Returns the first `count` nodes of a raw skeleton.
Skeleton first_nodes(const Skeleton& skeleton, std::size_t count) {
  Skeleton first;
  first.reserve(count);
  for (NodeIndex node = 0; node < count; ++node) {
    first.add_node(skeleton.parent[node], skeleton.position[node], skeleton.birth[node]);
  }
  return first;
}

}  // namespace

ColonizeTrace::ColonizeTrace(const ColonizingSpecies& species, std::vector<TracedTree> trees, int steps)
    : parameters_(species.parameters),
      limits_(species.limits),
      component_(species.component),
      trees_(std::move(trees)),
      steps_(steps) {}

Skeleton ColonizeTrace::standing_after(int step, const Scene& scene, Progress& progress) const {
  const ColonizingSpecies species{parameters_, scene, limits_, component_};
  std::vector<Skeleton> finished(trees_.size());
  parallel_for(trees_.size(), kTracedTreesAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      progress.check();
      const Skeleton& whole = trees_[k].skeleton;
      finished[k] = finished_tree(species, first_nodes(whole, count_at(whole, step)), trees_[k].root, progress);
    }
  });
  return join_skeletons(std::move(finished));
}

StepMarks ColonizeTrace::marks_of(int step, TraceRequest request, const Progress& progress) const {
  StepMarks marks;
  if (!request.has(TracePart::points) && !request.has(TracePart::pulls)) return marks;
  std::vector<TracedPlace> points;
  for (const TracedTree& tree : trees_) {
    progress.check();
    const std::vector<TracedPlace> own = tree.points.at(step, tree.origin);
    points.insert(points.end(), own.begin(), own.end());
  }
  if (request.has(TracePart::pulls)) marks.pulls = pulls(step, points, progress);
  if (request.has(TracePart::points)) marks.points = std::move(points);
  return marks;
}

/// Returns the pull of each free point on its nearest node, if the node is within the influence distance.
std::vector<TracedWay> ColonizeTrace::pulls(int step, const std::vector<TracedPlace>& points,
                                            const Progress& progress) const {
  std::vector<TracedWay> pulls;
  std::vector<NumberedPoint> nodes;
  for (const TracedTree& tree : trees_) {
    const std::size_t count = count_at(tree.skeleton, step);
    for (std::size_t node = 0; node < count; ++node) {
      nodes.push_back({tree.root + tree.skeleton.position[node], static_cast<std::uint32_t>(nodes.size())});
    }
  }
  std::vector<Vec3> positions;
  positions.reserve(nodes.size());
  for (const NumberedPoint& node : nodes) positions.push_back(node.position);
  if (nodes.empty()) return pulls;
  const NodeTree tree(std::move(nodes), progress);
  std::size_t asked = 0;
  for (const TracedPlace& point : points) {
    if (++asked % kPointsPerCheck == 0) progress.check();
    if (point.state != PlaceState::free) continue;
    NearestFew nearest;
    tree.search(point.position, nearest);
    const Vec3 node = positions[nearest.node(0)];
    if (glm::distance(node, point.position) <= static_cast<float>(parameters_.influence)) {
      pulls.push_back({node, point.position});
    }
  }
  return pulls;
}

std::uint64_t ColonizeTrace::bytes() const {
  std::uint64_t sum = trees_.capacity() * sizeof(TracedTree);
  for (const TracedTree& tree : trees_) sum += tree.skeleton.bytes() + tree.points.bytes();
  return sum;
}

}  // namespace meristem
