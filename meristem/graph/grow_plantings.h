// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/growth_traces.h"
#include "meristem/plant/planting.h"

namespace meristem {

/// A batch that has placed whole plants.
struct PlantingBatch {
  ComponentIndex component = 0;
  std::shared_ptr<const BatchResult> result;
};

/// Grows what the batches ask for, equal requests once and different ones side by side, and says where it stands: in
/// the order of the components and batches. The plants stand as `view` says, and what it wishes to be recorded goes to
/// `traces`, unless that is null. Throws InputError where there are too many variants or their nodes, and where one
/// cannot grow; Cancelled.
std::vector<Planting> grow_plantings(const Graph& graph, std::vector<PlantingBatch> batches, const GrowthView& view,
                                     GrowthTraces* traces, CacheRun& results, Progress& progress);

}  // namespace meristem
