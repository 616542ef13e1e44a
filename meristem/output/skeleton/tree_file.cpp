// SPDX-License-Identifier: Apache-2.0
// Writes tree files, one line per tree. Nodes of several trees may alternate in one skeleton, so the nodes are first
// sorted by tree.
//
// Based on: the tree files of T. Lowe, treetools (CSIRO), which describe branches as chains of cylinders.
#include "meristem/output/skeleton/tree_file.h"

#include <cstdint>
#include <vector>

#include "meristem/base/atomic_file.h"
#include "meristem/output/skeleton/cylinders.h"
#include "meristem/output/write/block_writer.h"
#include "meristem/output/write/csv.h"
#include "meristem/output/write/finite.h"
#include "meristem/output/write/z_up.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

namespace {

constexpr std::size_t kTreeFileNumbers = 7;

/// A node prepared for its line.
struct TreeFileNode {
  Vec3 position{0};
  float radius = 0;
  std::uint32_t branch = 0;
  std::int32_t parent = -1;  // number within its tree
  std::uint16_t order = 0;
  bool begins_line = false;
};

/// Appends the nodes of a skeleton tree by tree.
void append_trees(const Skeleton& skeleton, std::uint32_t first_axis, std::vector<TreeFileNode>& nodes) {
  std::vector<std::uint32_t> tree(skeleton.node_count());
  std::vector<std::uint32_t> number(skeleton.node_count());  // for each node, its number within its tree
  std::vector<std::uint32_t> sizes;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.is_root(node)) sizes.push_back(0);
    tree[node] = skeleton.is_root(node) ? static_cast<std::uint32_t>(sizes.size() - 1) : tree[skeleton.parent[node]];
    number[node] = sizes[tree[node]]++;
  }
  std::vector<std::size_t> first;  // for each tree, its first index among all nodes
  std::size_t next = nodes.size();
  for (const std::uint32_t size : sizes) {
    first.push_back(next);
    next += size;
  }
  nodes.resize(next);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    TreeFileNode& made = nodes[first[tree[node]] + number[node]];
    const NodeIndex parent = skeleton.parent[node];
    made.position = z_up(skeleton.position[node]);
    made.radius = cylinder_radius(skeleton, node);
    made.branch = first_axis + skeleton.axis[node];
    made.order = skeleton.order[node];
    made.begins_line = parent == kNoNode;
    if (parent != kNoNode) made.parent = static_cast<std::int32_t>(number[parent]);
  }
}

std::vector<TreeFileNode> nodes_of(const Plant& plant) {
  std::vector<TreeFileNode> nodes;
  nodes.reserve(plant.node_count());
  std::uint32_t first_axis = 0;
  for (const Stem& stem : plant.stems) {
    append_trees(stem.skeleton, first_axis, nodes);
    first_axis += static_cast<std::uint32_t>(stem.skeleton.axis_count());
  }
  return nodes;
}

void append_segment(const TreeFileNode& node, bool is_first, std::string& out) {
  if (node.begins_line) {
    if (!is_first) out += '\n';
  } else {
    out += ", ";
  }
  for (const float value : {node.position.x, node.position.y, node.position.z, node.radius}) {
    append_csv_number(value, out);
    out += ',';
  }
  append_csv_number(node.parent, out);
  out += ',';
  append_csv_number(node.branch, out);
  out += ',';
  append_csv_number(node.order, out);
}

}  // namespace

void write_tree_file(const Plant& grown, const SizeLimits& limits, const std::string& path,
                     const Provenance& provenance, Progress& progress) {
  const ExpandedPlant expanded(grown, limits, progress);
  require_finite(*expanded);
  const std::vector<TreeFileNode> nodes = nodes_of(*expanded);
  progress.begin("writing a tree file", nodes.size());
  AtomicFile file(path);
  std::string head = "# tree file\n";
  for (const std::string& line : provenance_lines(provenance, "metres, z up")) head += "# " + line + "\n";
  head += "x,y,z,radius,parent_id,branch_id,order\n";
  file.write(head);
  const auto fill = [&](std::size_t begin, std::size_t end, std::string& out) {
    for (std::size_t k = begin; k < end; ++k) append_segment(nodes[k], k == 0, out);
  };
  BlockWriter(file, progress).write(nodes.size(), kTreeFileNumbers * kCsvNumberBytes, fill);
  if (!nodes.empty()) file.write("\n");
  file.commit();
}

}  // namespace meristem
