// SPDX-License-Identifier: Apache-2.0
// The steps of post-processing in their fixed order: decimate, relax, subdivide. The numbers of tracked nodes are
// updated after each step.
#include "meristem/plant/finish.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace meristem {

namespace {

double total_length(const Skeleton& skeleton) {
  double length = 0;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.is_root(node)) continue;
    length += glm::distance(skeleton.position[node], skeleton.position[skeleton.parent[node]]);
  }
  return length;
}

/// Returns the marks of tracked nodes, indexed by their current numbers.
TrackedNodes present(const TrackedNodes& tracked, std::size_t nodes) {
  TrackedNodes next{std::vector<std::uint8_t>(nodes, 0), {}};
  for (std::size_t node = 0; node < tracked.now.size(); ++node) {
    if (tracked.stays[node] != 0) next.stays[tracked.now[node]] = 1;
  }
  return next;
}

/// Renumbers the axes in the order of their first nodes, because axes may have been removed.
void number_axes(Skeleton& skeleton) {
  std::vector<AxisIndex> number;
  AxisIndex axes = 0;
  for (AxisIndex& axis : skeleton.axis) {
    if (number.size() <= axis) number.resize(axis + 1, kNoNode);
    if (number[axis] == kNoNode) number[axis] = axes++;
    axis = number[axis];
  }
}

/// Updates the current numbers of tracked nodes after one more step.
void follow(TrackedNodes& tracked, const TrackedNodes& step) {
  for (NodeIndex& now : tracked.now) now = now == kNoNode ? kNoNode : step.now[now];
}

}  // namespace

Skeleton finish(Skeleton skeleton, const FinishOptions& wanted, const FinishContext& context, TrackedNodes* tracked) {
  TrackedNodes none;
  TrackedNodes& all = tracked != nullptr ? *tracked : none;
  all.stays.resize(skeleton.node_count(), 0);
  all.now.resize(skeleton.node_count());
  std::iota(all.now.begin(), all.now.end(), 0);
  if (wanted.decimate > 0) {
    TrackedNodes next = present(all, skeleton.node_count());
    skeleton = decimate(skeleton, wanted.decimate * context.step, context.step, context.is_open, &next);
    follow(all, next);
    context.progress.check();
  }
  if (wanted.relax) relax_angles(skeleton, context.is_open);
  if (wanted.subdivide > 0) {
    const double spacing = wanted.subdivide * context.step;
    const double nodes = static_cast<double>(skeleton.node_count()) + total_length(skeleton) / spacing;
    context.require_nodes(static_cast<std::uint64_t>(std::min(nodes, 1e18)));
    TrackedNodes next = present(all, skeleton.node_count());
    skeleton = subdivide(skeleton, spacing, context.is_open, &next);
    follow(all, next);
    context.progress.check();
  }
  number_axes(skeleton);
  return skeleton;
}

}  // namespace meristem
