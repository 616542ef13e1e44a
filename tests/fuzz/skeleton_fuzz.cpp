// SPDX-License-Identifier: Apache-2.0
// Fuzzes tables of nodes, cylinders and trees: either errors with their places, or a skeleton with parents before
// children. It must be writable and measurable, and growth must be able to continue from it.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "meristem/base/parallel.h"
#include "meristem/grow/organize/organize.h"
#include "meristem/measure/measures.h"
#include "meristem/plant/file/node_table.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/plant/split_trees.h"
#include "tests/fuzz/require.h"

namespace {

using namespace meristem;

void check_table(const NodeTable& table) {
  for (NodeIndex node = 0; node < table.node_count(); ++node) {
    require(table.parent[node] == kNoNode || table.parent[node] < node);
    require(!std::isnan(table.position[node].x + table.position[node].y + table.position[node].z));
  }
}

void check_skeleton(const Skeleton& skeleton) {
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    require(skeleton.radius[node] >= 0 && std::isfinite(skeleton.position[node].y));
    if (!skeleton.is_root(node)) require(skeleton.order[node] >= skeleton.order[skeleton.parent[node]]);
  }
  Progress progress;
  const Skeleton* const one = &skeleton;
  require(measure_skeletons(std::span(&one, 1), nullptr, {}, progress).whole.nodes == skeleton.node_count());
}

/// Grows one iteration on the first tree. Existing wood must keep its place.
void go_on(const Skeleton& skeleton, const SizeLimits& limits) {
  Skeleton tree = split_trees(skeleton).front();
  assign_pipe_radii(tree, {});
  const Vec3 root = tree.position[0];
  for (Vec3& position : tree.position) position -= root;
  OrganizeParameters parameters;
  parameters.iterations = 1;
  const Scene scene;
  Stand stand;
  stand.add(make_organizer(stand, {{Frame{}, nullptr, std::make_shared<const Skeleton>(tree)}}, parameters,
                           RandomKey(1), scene, limits, "tree"));
  Progress progress;
  stand.grow(progress);
  require(stand.take_skeletons(progress).front().node_count() >= 1);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer requires this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  SizeLimits limits;
  limits.nodes = 2000;
  limits.mesh_bytes = 20'000'000;
  const ThreadLimit one_thread(1);
  try {
    const NodeTable table = read_node_table(text, "fuzz", limits);
    check_table(table);
    const Skeleton skeleton = skeleton_of(table, {}, "fuzz");
    check_skeleton(skeleton);
    go_on(skeleton, limits);
  } catch (const InputError& error) {
    require(!error.diagnostics().empty() && error.diagnostics().size() <= limits.diagnostics);
    for (const Diagnostic& diagnostic : error.diagnostics()) require(!diagnostic.message.empty());
  }
  return 0;
}
