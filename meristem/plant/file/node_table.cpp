// SPDX-License-Identifier: Apache-2.0
// Converts a table of nodes to a skeleton: chooses the child that continues each axis, and moves positions to the
// world.
#include "meristem/plant/file/node_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/number_limit.h"
#include "meristem/base/reading_stop.h"

namespace meristem {

namespace {

/// Returns, for each node, the child that continues its axis, or kNoNode.
std::vector<NodeIndex> continuations(const NodeTable& table) {
  const std::size_t count = table.node_count();
  std::vector<NodeIndex> next(count, kNoNode);
  if (!table.branch.empty()) {
    for (NodeIndex node = 0; node < count; ++node) {
      const NodeIndex parent = table.parent[node];
      if (parent == kNoNode || next[parent] != kNoNode || table.branch[parent] != table.branch[node]) continue;
      next[parent] = node;
    }
    return next;
  }
  bool has_radii = true;
  for (const double radius : table.radius) has_radii = has_radii && !std::isnan(radius);
  std::vector<double> weight = table.radius;
  if (!has_radii) {
    // Compute the length to the farthest tip, including the segment that ends in the node.
    weight.assign(count, 0);
    for (NodeIndex node = static_cast<NodeIndex>(count); node-- > 0;) {
      const NodeIndex parent = table.parent[node];
      if (parent == kNoNode) continue;
      weight[node] += glm::distance(table.position[node], table.position[parent]);
      weight[parent] = std::max(weight[parent], weight[node]);
    }
  }
  for (NodeIndex node = 0; node < count; ++node) {
    const NodeIndex parent = table.parent[node];
    if (parent == kNoNode) continue;
    if (next[parent] == kNoNode || weight[node] > weight[next[parent]]) next[parent] = node;
  }
  return next;
}

/// Converts a position of the file to world axes: y up, north toward -z.
DVec3 world(DVec3 position, bool is_y_up) { return is_y_up ? position : DVec3(position.x, position.z, -position.y); }

}  // namespace

Skeleton skeleton_of(const NodeTable& table, const NodeTablePlacement& placement, const std::string& file) {
  DVec3 origin(0);
  if (placement.begins_at_origin && table.node_count() > 0) origin = table.position.front();
  const std::vector<NodeIndex> next = continuations(table);
  const auto thicker = static_cast<float>(placement.radius_factor);
  Skeleton skeleton;
  skeleton.reserve(table.node_count());
  AxisIndex axes = 0;
  StopCounter stop;
  for (NodeIndex node = 0; node < table.node_count(); ++node) {
    stop.step();
    // Subtract in doubles first, because map coordinates are too large for floats.
    const DVec3 at = placement.unit * world(table.position[node] - origin, placement.is_y_up);
    if (!(std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}) <= kMaxCoordinate)) {
      throw InputError(Diagnostic{.message = "the node is too far away",
                                  .expected = fmt::format("coordinates within {:.0f} m", kMaxCoordinate),
                                  .file = file,
                                  .line = table.line[node]});
    }
    const NodeIndex parent = table.parent[node];
    skeleton.add_node(parent, Vec3(at), table.birth.empty() ? 0 : table.birth[node]);
    const double radius = placement.unit * table.radius[node];
    skeleton.radius[node] = std::isnan(radius) ? 0 : static_cast<float>(radius) * thicker;
    if (!(skeleton.radius[node] <= kMaxRadius)) {
      throw InputError(Diagnostic{.message = fmt::format("the radius of {:.6g} m is too large", radius * thicker),
                                  .expected = fmt::format("radii up to {:.0f} m", kMaxRadius),
                                  .file = file,
                                  .line = table.line[node]});
    }
    if (parent != kNoNode && next[parent] == node) {
      skeleton.axis[node] = skeleton.axis[parent];
      skeleton.order[node] = skeleton.order[parent];
      continue;
    }
    skeleton.axis[node] = axes++;
    if (parent == kNoNode) continue;
    if (skeleton.order[parent] == std::numeric_limits<std::uint16_t>::max()) {
      throw InputError(Diagnostic{.message = "the branching order of the node is too high",
                                  .expected = fmt::format("orders up to {}", std::numeric_limits<std::uint16_t>::max()),
                                  .file = file,
                                  .line = table.line[node]});
    }
    skeleton.order[node] = static_cast<std::uint16_t>(skeleton.order[parent] + 1);
  }
  return skeleton;
}

}  // namespace meristem
