// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/graph/batch_queue.h"
#include "meristem/graph/walk/walk_context.h"

namespace meristem {

/// The grown plants of a batch. Empty for batches of components that do not grow.
struct Grown {
  CacheKey key;                       ///< key of the growth; unset: nobody else needs the skeletons
  std::shared_ptr<GrownBatch> batch;  ///< one skeleton per instance
  /// For each instance the growth that it shows, or null. Empty if the component does not show the growth of others.
  std::vector<std::shared_ptr<const GrowthTrace>> watched{};
};

/// Grows the plants of the batches that wait for their growth.
class BatchGrower {
 public:
  /// `context` must outlive this object.
  explicit BatchGrower(const WalkContext& context) : context_(context) {}

  /// Grows the plants of batches, or finds them in the cache. Returns the grown plants of each batch. Plants of all
  /// batches compete with each other, except plants of components that grow alone.
  std::vector<Grown> grow(std::span<const Batch> batches) const;

  /// Returns the skeleton of an instance as the view shows it: at a step, after the planned operations, or fully grown.
  /// Moves a fully grown skeleton out of `grown` if nobody else needs it, so call this once per instance.
  Skeleton take_skeleton(const Grown& grown, ComponentIndex component, std::size_t instance, Progress& progress) const;

 private:
  bool grows_alone(const Batch& batch) const;
  std::vector<Grown> grow_together(std::span<const Batch> batches) const;
  std::vector<Grown> find_stand(std::span<const Batch> batches) const;
  void grow_stand(std::span<const Batch> batches, std::span<Grown> grown) const;
  Grown grow_alone(const Batch& batch) const;
  void plant(const Batch& batch, const Site& site, Stand& stand) const;
  void find_watched(std::span<const Batch> batches, std::span<Grown> all, std::size_t watcher) const;

  const WalkContext& context_;
};

}  // namespace meristem
