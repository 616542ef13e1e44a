// SPDX-License-Identifier: Apache-2.0
// Levels of detail of the shipped models. Counters: the time of a level, its triangles, and `of_before`, its triangles
// divided by the triangles of the level before. Also the share of the whole plant's outline (outline.h) from 50
// directions, smallest and mean. Pictures have 128 pixels at level 1, and half as many at each further level.
// `worth_a_file` is 1 if `meristem grow --lod` would write the level. Runs all models unless a filter is given.
#include <algorithm>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/document/models.h"
#include "meristem/export/detail_levels.h"
#include "meristem/shape/outline/outline.h"

namespace {

using namespace meristem;

const std::string kModels = std::string(MERISTEM_SOURCE_DIR) + "/models";

void levels(benchmark::State& state, const std::string& name) {
  const std::string file = model_path(kModels, name);
  const Document document = read_document(read_text_file(file), file, builtin_components());
  Progress progress;
  const GrownDocument grown = grow_document(document, progress, {.up_to = GrownPart::meshes});
  const auto level = static_cast<int>(state.range(0));
  const auto triangles_of = [&](int of) {
    return of == 0 ? grown.meshes.triangle_count()
                   : mesh_detail(document, grown.plant, {.level = of}, progress).triangle_count();
  };
  MeshScene made;
  while (state.KeepRunning()) {
    made = {};
    made = mesh_detail(document, grown.plant, {.level = level}, progress);
  }
  const std::uint64_t before = triangles_of(level - 1);
  const OutlineOverlap overlap = outline_overlap(grown.meshes, made, {.size = pixels_of_level(level)}, progress);
  state.counters["triangles"] = static_cast<double>(made.triangle_count());
  state.counters["of_before"] = static_cast<double>(made.triangle_count()) / static_cast<double>(before);
  state.counters["least"] = overlap.min();
  state.counters["mean"] = overlap.mean();
  state.counters["growth"] = overlap.mean_growth();
  state.counters["worth_a_file"] = error_of_level(grown.meshes, before, made, level, progress).empty() ? 1 : 0;
}

void add_models() {
  for (const std::string& name : model_names(kModels)) {
    if (bench::is_small() && name != "low-poly-fir") continue;
    benchmark::RegisterBenchmark(name.c_str(), [name](benchmark::State& state) { levels(state, name); })
        ->ArgName("level")
        ->DenseRange(1, bench::sized(3, 1))
        ->Iterations(1)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

int main(int count, char** arguments) {
  add_models();
  return bench::run(count, arguments);
}
