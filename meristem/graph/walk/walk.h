// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/progress.h"
#include "meristem/graph/batch_queue.h"
#include "meristem/graph/emitter_context.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/growth_traces.h"
#include "meristem/graph/instance_variables.h"
#include "meristem/graph/link_sites.h"
#include "meristem/graph/memory_limit.h"
#include "meristem/graph/walk/batch_grower.h"
#include "meristem/graph/walk/component_meshes.h"
#include "meristem/graph/walk/result_keys.h"
#include "meristem/graph/walk/shown_growth.h"
#include "meristem/graph/walk/walk_context.h"
#include "meristem/graph/walk/walk_visitor.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Options of a walk.
struct WalkOptions {
  Cache* cache = nullptr;  ///< results of earlier walks; null: nothing is reused
  GrowthView view{};       ///< how plants that grow are shown, and the parts of their growth to record
  /// Number of instances that one emitter expands, and that one block of a result holds. Components that grow have one
  /// instance per block. Must be kBlock with a cache, because cached results have blocks of this size.
  std::size_t per_block = kBlock;
  /// True: large batches expand slice by slice, each with all its descendants, so that few sites are in memory. The
  /// visitor receives slices as batches. False: all batches are whole, as results in a cache must be.
  bool in_slices = false;
  bool will_place = false;  ///< true: plants of other documents will grow, so too many of them are refused at once
  bool will_mesh = false;   ///< true: all surfaces will be meshed, so too many triangles are refused at once
};

/// Expands a graph batch by batch, and shows each batch to a visitor.
class Walk {
 public:
  /// All arguments except `options` must outlive this object. `time` is the document's, seconds.
  Walk(const Graph& graph, const Scene& scene, double time, Progress& progress, WalkOptions options);
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;

  /// Expands all instances, or stops when the visitor is done. Call it once. Throws InputError if the graph exceeds a
  /// limit or a number is not finite, and Cancelled.
  void run(WalkVisitor& visitor);

  /// Returns the results of all batches after a whole run. Their order does not depend on slices.
  std::vector<FinishedBatch> take_results() { return queue_.take_results(); }
  std::uint64_t mesh_bytes() const { return meshes_.bytes().sum(); }  ///< memory of the meshes of all results
  /// Returns the run of the cache that the walk has begun. The walk does not end it, so a walk whose caller does not
  /// end it leaves earlier results in the cache.
  CacheRun& cache_run() { return results_; }

 private:
  /// A batch whose children are placed.
  struct Parent {
    const Batch& batch;
    CacheKey key;  // key of its result
    const BatchResult& result;
  };

  void add_root();
  void expand(const Batch& batch, const Grown& grown);
  std::shared_ptr<const BatchResult> find_result(ComponentIndex component, CacheKey key);
  std::shared_ptr<BatchResult> make_result(const Batch& batch, const std::vector<LinkIndex>& links, const Grown& grown);
  Emitted expand_alone(const Batch& batch, const std::vector<LinkIndex>& links, std::size_t instance);
  EmitterContext context_of(const Batch& batch, const std::vector<LinkIndex>& links);
  void show(const Batch& batch, const std::vector<LinkIndex>& links, const BatchResult& result, const Grown& grown);
  void require_placed(ComponentIndex component, const BatchResult& result) const;
  void place_children(LinkIndex link, const Parent& parent, BatchResult* own);
  bool has_children_of(const std::vector<LinkIndex>& links, CacheKey parent, std::uint64_t instances);
  CacheKey key_of_children(LinkIndex link, CacheKey parent) const;
  std::shared_ptr<const Sites> places_of(SiteList sites) const;
  WantedSites wanted_by(const std::vector<LinkIndex>& links) const;
  std::size_t per_block(ComponentIndex component) const;

  const WalkOptions options_;
  const Graph& graph_;
  const Directions directions_;  // directions of the scene
  Progress& progress_;
  CacheRun results_;
  const ShownGrowth shown_;
  const ResultKeys keys_;
  const WalkContext context_;
  const InstanceVariables variables_;
  const LinkSites links_;
  const BatchGrower grower_;
  ComponentMeshes meshes_;
  BatchQueue queue_;
  MemoryLimit memory_;
  WalkVisitor* visitor_ = nullptr;   // set during the run
  std::uint64_t instances_ = 1;      // number of instances so far; the root is the first
  std::uint64_t nodes_ = 0;          // number of skeleton nodes so far
  std::vector<std::uint64_t> made_;  // number of instances so far, by component
};

}  // namespace meristem
