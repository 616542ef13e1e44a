// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/growth_traces.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Expands a graph into the tree of its instances and gives what they make.
///
/// Components that grow wait until all others above them have been expanded, then grow together in one stand.
/// Randomness is keyed by the instance's path, so editing one component leaves the others as they were; blocks of
/// instances expand in parallel with the same result on any number of threads. Nothing recurses. The graph's structure
/// must be sound (analyse_structure). With a `cache`, everything that has not changed since the cache's last expansion
/// is taken from there, as far as components, links and scenes have fingerprints; batch.h says what an expansion leaves
/// for the next one. Textures are sketches until paint_textures (looks.h). Throws InputError (limits, numbers that are
/// not finite), Cancelled.
Plant expand(const Graph& graph, const Scene& scene, double time, Progress& progress, Cache* cache = nullptr);

/// What an expansion may keep and show besides.
struct ExpandOptions {
  Cache* cache = nullptr;          ///< results of earlier expansions; null: everything is made anew
  GrowthView view;                 ///< the step of growth that is shown
  GrowthTraces* traces = nullptr;  ///< gets what `view` wishes to be recorded; null: nobody asks
};

/// The same with the plants as `view` says. Whatever is recorded, the plant has the same bytes.
Plant expand(const Graph& graph, const Scene& scene, double time, Progress& progress, const ExpandOptions& options);

}  // namespace meristem
