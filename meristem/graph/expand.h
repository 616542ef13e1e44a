// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/growth_traces.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Expands a graph into the tree of its instances and returns the plant that the instances make. `time` is the time of
/// the document, seconds.
///
/// Components that grow wait until all others above them have been expanded, then grow together in one stand. Random
/// numbers depend on an instance's path, so editing one component leaves the others unchanged. Blocks of instances
/// expand in parallel, with equal results on any number of threads. Nothing recurses. The graph's structure must be
/// sound (analyse_structure).
///
/// With a `cache`, everything unchanged since the cache's last expansion is reused if its components, links and scene
/// have fingerprints (see batch.h). Textures are sketches until paint_textures() paints them (looks.h). Throws
/// InputError (limits, numbers that are not finite) and Cancelled.
Plant expand(const Graph& graph, const Scene& scene, double time, Progress& progress, Cache* cache = nullptr);

/// Options of an expansion: what it keeps, shows and records.
struct ExpandOptions {
  Cache* cache = nullptr;          ///< results of earlier expansions; null: nothing is reused
  GrowthView view;                 ///< the step of growth that is shown
  GrowthTraces* traces = nullptr;  ///< receives the records that `view` requests; null: nothing is recorded
  /// True: all surfaces will be meshed at full detail, so a graph that is certain to exceed limits.triangles is
  /// refused.
  bool will_mesh = false;
};

/// Expands a graph as above, with the plants shown as `options.view` requests. Recording does not change the plant's
/// bytes.
Plant expand(const Graph& graph, const Scene& scene, double time, Progress& progress, const ExpandOptions& options);

}  // namespace meristem
