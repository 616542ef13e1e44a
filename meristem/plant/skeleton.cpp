// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/skeleton.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "meristem/base/hash.h"

namespace meristem {

void Skeleton::reserve(std::size_t nodes) {
  parent.reserve(nodes);
  position.reserve(nodes);
  radius.reserve(nodes);
  axis.reserve(nodes);
  order.reserve(nodes);
  birth.reserve(nodes);
  for (auto& [name, values] : extra) values.reserve(nodes);
}

std::size_t Skeleton::axis_count() const {
  const auto last = std::max_element(axis.begin(), axis.end());
  return last == axis.end() ? 0 : std::size_t{*last} + 1;
}

std::uint64_t Skeleton::bytes() const {
  const auto bytes_of = [](const auto& column) {
    return column.capacity() * sizeof(typename std::decay_t<decltype(column)>::value_type);
  };
  std::uint64_t sum = bytes_of(parent) + bytes_of(position) + bytes_of(radius) + bytes_of(axis) + bytes_of(order) +
                      bytes_of(birth) + operations.bytes();
  for (const auto& [name, values] : extra) sum += bytes_of(values);
  return sum;
}

NodeIndex Skeleton::add_node(NodeIndex parent_node, Vec3 node_position, float node_birth) {
  const auto node = static_cast<NodeIndex>(node_count());
  assert(parent_node == kNoNode || parent_node < node);
  parent.push_back(parent_node);
  position.push_back(node_position);
  radius.push_back(0);
  axis.push_back(0);
  order.push_back(0);
  birth.push_back(node_birth);
  for (auto& [name, values] : extra) values.push_back(0);
  return node;
}

void Skeleton::append(Skeleton more) {
  if (node_count() == 0) {
    *this = std::move(more);
    return;
  }
  const auto first = static_cast<NodeIndex>(node_count());
  const auto first_axis = static_cast<AxisIndex>(axis_count());
  for (NodeIndex& node : more.parent) node = node == kNoNode ? kNoNode : first + node;
  for (AxisIndex& index : more.axis) index += first_axis;
  const auto join = [](auto& column, const auto& rest) { column.insert(column.end(), rest.begin(), rest.end()); };
  join(parent, more.parent);
  join(position, more.position);
  join(radius, more.radius);
  join(axis, more.axis);
  join(order, more.order);
  join(birth, more.birth);
  for (const auto& [name, values] : more.extra) {
    std::vector<float>& column = extra[name];
    column.resize(first, 0);
    join(column, values);
  }
  for (auto& [name, values] : extra) values.resize(node_count(), 0);
  operations.append(more.operations);
}

NodeChildren::NodeChildren(const Skeleton& skeleton) : first(skeleton.node_count() + 1, 0) {
  const std::size_t nodes = skeleton.node_count();
  // Count the children of each node, one position further on.
  for (const NodeIndex parent : skeleton.parent) {
    if (parent != kNoNode) ++first[parent + 1];
  }
  // Sum up the counts, so that each entry is the begin of a node's children.
  for (std::size_t node = 0; node < nodes; ++node) first[node + 1] += first[node];
  // Write every node to the next free position of its parent.
  child.resize(first[nodes]);
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (NodeIndex node = 0; node < nodes; ++node) {
    if (!skeleton.is_root(node)) child[next[skeleton.parent[node]]++] = node;
  }
}

SkeletonAxes::SkeletonAxes(const Skeleton& skeleton) {
  const std::size_t axes = skeleton.axis_count();
  first.assign(axes + 1, 0);
  for (const AxisIndex axis : skeleton.axis) ++first[axis + 1];
  for (std::size_t axis = 0; axis < axes; ++axis) first[axis + 1] += first[axis];
  node.resize(skeleton.node_count());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (NodeIndex index = 0; index < skeleton.node_count(); ++index) node[next[skeleton.axis[index]]++] = index;
}

std::vector<float> tip_distance(const Skeleton& skeleton) {
  std::vector<float> distance(skeleton.node_count(), 0);
  for (std::size_t node = skeleton.node_count(); node-- > 0;) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode) continue;
    const float segment = glm::distance(skeleton.position[node], skeleton.position[parent]);
    distance[parent] = std::max(distance[parent], distance[node] + segment);
  }
  return distance;
}

Box bounds(const Skeleton& skeleton) {
  Box box;
  for (std::size_t node = 0; node < skeleton.node_count(); ++node) {
    box.add(skeleton.position[node] - skeleton.radius[node]);
    box.add(skeleton.position[node] + skeleton.radius[node]);
  }
  return box;
}

std::string skeleton_hash(const Skeleton& skeleton) {
  std::vector<std::byte> bytes;
  const auto append = [&bytes]<class T>(const std::vector<T>& column) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto view = std::as_bytes(std::span(column));
    bytes.insert(bytes.end(), view.begin(), view.end());
  };
  append(skeleton.parent);
  append(skeleton.position);
  append(skeleton.radius);
  append(skeleton.axis);
  append(skeleton.order);
  append(skeleton.birth);
  for (const auto& [name, values] : skeleton.extra) {
    append(std::vector<char>(name.begin(), name.end()));
    append(values);
  }
  return hash128_hex(bytes);
}

}  // namespace meristem
