// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/walk/result_keys.h"
#include "meristem/graph/walk/shown_growth.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The data that all parts of a walk share.
struct WalkContext {
  const Graph& graph;
  const Scene& scene;
  const Directions& directions;  ///< directions of the scene
  double time = 0;               ///< seconds
  Progress& progress;
  const ShownGrowth& shown;
  const ResultKeys& keys;
  CacheRun& results;
};

}  // namespace meristem
