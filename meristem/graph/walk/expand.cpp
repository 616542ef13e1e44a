// SPDX-License-Identifier: Apache-2.0
// Makes a plant from the results of all batches. A visitor collects the records of their growth during the walk. After
// the walk, the results are assembled, and the plants of other documents that they place grow.
#include "meristem/graph/expand.h"

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meristem/graph/grow_plantings.h"
#include "meristem/graph/plant_assembly.h"
#include "meristem/graph/walk/walk.h"

namespace meristem {

namespace {

/// Collects the records that a view requests.
class TraceVisitor final : public WalkVisitor {
 public:
  /// Without `traces`, nothing is collected.
  TraceVisitor(const Graph& graph, const GrowthView& view, GrowthTraces* traces)
      : graph_(graph), view_(view), traces_(traces) {
    if (traces_ == nullptr) return;
    traces_->step = view.step;
    traces_->of = view.of;
    traces_->recorded = view.request;
  }

  void on_expanded(const ExpandedBatch& expanded) override {
    if (traces_ == nullptr) return;
    const std::string& id = graph_.components[expanded.batch.component].id;
    traces_->add_steps(id, expanded.result.growth_steps, view_);
    if (expanded.grown == nullptr) return;
    for (const std::shared_ptr<const GrowthTrace>& trace : expanded.grown->traces) {
      const std::uint32_t instance = instances_[expanded.batch.component]++;
      if (trace == nullptr) continue;
      traces_->growths.push_back({id, instance, trace});
      traces_->add_steps(id, trace->last_step(), view_);
    }
  }

 private:
  const Graph& graph_;
  const GrowthView& view_;
  GrowthTraces* traces_;
  std::unordered_map<ComponentIndex, std::uint32_t> instances_;  // number of grown instances so far
};

bool places_plants(const BatchResult& result) {
  return std::ranges::any_of(result.blocks, [](const Emitted& block) { return !block.plants.empty(); });
}

}  // namespace

Plant expand(const Graph& graph, const Scene& scene, double time, Progress& progress, Cache* cache) {
  return expand(graph, scene, time, progress, ExpandOptions{.cache = cache});
}

Plant expand(const Graph& graph, const Scene& scene, double time, Progress& progress, const ExpandOptions& options) {
  Walk walk(graph, scene, time, progress,
            {.cache = options.cache,
             .view = options.view,
             .in_slices = options.cache == nullptr,
             .will_place = true,
             .will_mesh = options.will_mesh});
  TraceVisitor visitor(graph, options.view, options.traces);
  walk.run(visitor);
  PlantAssembly assembly(graph);
  std::vector<PlantingBatch> planting;
  for (FinishedBatch& finished : walk.take_results()) {
    if (places_plants(*finished.result)) planting.push_back({finished.component, finished.result});
    assembly.add(finished.component, std::move(finished.result), finished.own);
  }
  Plant plant = assembly.run(walk.mesh_bytes(), progress);
  plant.plantings =
      grow_plantings(graph, std::move(planting), options.view, options.traces, walk.cache_run(), progress);
  walk.cache_run().end();
  return plant;
}

}  // namespace meristem
