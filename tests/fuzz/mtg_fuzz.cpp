// SPDX-License-Identifier: Apache-2.0
// Any bytes as an MTG file: either faults that have their place in it, or entities in which all that something hangs on
// comes before it, as a skeleton whose measures can be taken.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "meristem/measure/measures.h"
#include "meristem/output/mtg_skeleton.h"
#include "tests/fuzz/require.h"

namespace {

using namespace meristem;

void check_tree(const MtgTree& tree) {
  for (MtgVertex vertex = 1; vertex < tree.vertex_count(); ++vertex) {
    require(tree.complex[vertex] < vertex && tree.scale(tree.complex[vertex]) == tree.scale(vertex) - 1);
    const MtgVertex parent = tree.parent[vertex];
    require((parent == kNoVertex) == (tree.edge[vertex] == MtgEdge::none));
    require(parent == kNoVertex || (parent < vertex && tree.scale(parent) == tree.scale(vertex)));
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer looks for this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Limits limits;
  limits.nodes = 2000;
  try {
    const MtgTree tree = read_mtg(text, "fuzz", limits);
    check_tree(tree);
    const MtgSkeleton plant = skeleton_of(tree, "fuzz");
    Progress progress;
    const Skeleton* const skeleton = &plant.skeleton;
    const StandMeasures measures = measure_skeletons(std::span(&skeleton, 1), nullptr, {}, progress);
    require(measures.whole.nodes == plant.vertex.size());
  } catch (const InputError& error) {
    require(!error.diagnostics().empty() && error.diagnostics().size() <= limits.diagnostics);
    for (const Diagnostic& diagnostic : error.diagnostics()) {
      require(!diagnostic.message.empty() && diagnostic.file == "fuzz" && diagnostic.line >= 0);
    }
  }
  return 0;
}
