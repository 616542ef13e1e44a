// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/growth_traces.h"
#include "meristem/plant/planting.h"

namespace meristem {

/// Maximum number of different plants of other documents.
inline constexpr std::uint64_t kMaxVariants = 1000;

/// A batch that has placed whole plants.
struct PlantingBatch {
  ComponentIndex component = 0;
  std::shared_ptr<const BatchResult> result;
};

/// Grows the plants that the batches request. Equal requests grow once, different ones in parallel. Returns their
/// positions in the order of the components and batches. The plants are shown as `view` requests. Records go to
/// `traces` unless that is null. Throws InputError if there are too many variants or nodes, or if a plant cannot grow,
/// and Cancelled.
std::vector<Planting> grow_plantings(const Graph& graph, std::vector<PlantingBatch> batches, const GrowthView& view,
                                     GrowthTraces* traces, CacheRun& results, Progress& progress);

}  // namespace meristem
