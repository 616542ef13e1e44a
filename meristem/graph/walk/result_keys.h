// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/cache.h"
#include "meristem/graph/batch_queue.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/walk/shown_growth.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The kinds of sites that the links of a batch need.
struct WantedSites {
  bool children = false;  ///< sites for all links except branch links
  bool branches = false;  ///< sites for branch links
};

/// Keys of the results of a walk: hashes of everything that a result depends on. A key is unset if a dependence is
/// unknown, or if nothing is cached.
class ResultKeys {
 public:
  /// `graph`, `shown` and the scene must outlive this object. `time` is the document's, seconds.
  ResultKeys(const Graph& graph, const Scene& scene, double time, const ShownGrowth& shown, const CacheRun& results);

  /// Returns true if keys can be known. Otherwise sites need no hash.
  bool are_known() const { return surroundings_.has_value(); }
  /// Returns the key of the meshes that all instances of a component share.
  CacheKey of_meshes(ComponentIndex component) const;
  /// Returns the key of the growth of a batch's plants, without the plants that they compete with.
  CacheKey of_growth(const Batch& batch) const;
  /// Returns the key of a batch's result. `growth` is the key of its grown plants.
  CacheKey of_result(const Batch& batch, WantedSites wanted, CacheKey growth) const;

 private:
  CacheKey of_component(ComponentIndex component, CacheKey of_document, bool depends_on_time) const;

  const Graph& graph_;
  double time_;
  const ShownGrowth& shown_;
  CacheKey surroundings_;  // hash of the scene and the limits, on which all results depend
};

}  // namespace meristem
