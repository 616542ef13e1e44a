// SPDX-License-Identifier: Apache-2.0
// Fuzzes MTG files: either errors with their places, or entities that come after the entities that bear them. Their
// skeleton must have measures, and must be unchanged after writing and reading.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <unistd.h>

#include "meristem/base/read_file.h"
#include "meristem/measure/measures.h"
#include "meristem/output/skeleton/skeleton_mtg.h"
#include "meristem/plant/axis_labels.h"
#include "meristem/plant/mtg/mtg_skeleton.h"
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

Plant plant_of(const Skeleton& skeleton) {
  Plant plant;
  plant.stems.emplace_back().skeleton = skeleton;
  return plant;
}

/// Writes the skeleton to a file in memory and returns its text.
std::string written(const Skeleton& skeleton) {
  static const std::string kPath = "/dev/shm/mtg_fuzz_" + std::to_string(getpid());
  Progress progress;
  write_skeleton_mtg(plant_of(skeleton), {}, kPath, {}, progress);
  std::string text = read_file(kPath, SizeLimits{}.file_bytes);
  unlink(kPath.c_str());
  return text;
}

void check_round_trip(const Skeleton& skeleton) {
  const std::string text = written(skeleton);
  const Skeleton again = skeleton_of(read_mtg(text, "again", {}), "again", {}, {}).skeleton;
  require(skeleton_hash(again) == skeleton_hash(skeleton));
  require(axis_labels(again) == axis_labels(skeleton));
  require(written(again) == text);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer requires this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  SizeLimits limits;
  limits.nodes = 2000;
  try {
    const MtgTree tree = read_mtg(text, "fuzz", limits);
    check_tree(tree);
    const MtgSkeleton plant = skeleton_of(tree, "fuzz", {}, limits);
    check_round_trip(plant.skeleton);
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
