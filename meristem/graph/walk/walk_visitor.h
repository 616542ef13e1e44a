// SPDX-License-Identifier: Apache-2.0
// The interface between a walk over the instances of a graph and the computation that needs these instances. The walk
// decides on order, keys, random numbers, limits and caching. A visitor only reads what the walk shows.
#pragma once

#include <cstddef>
#include <span>

#include "meristem/base/function_ref.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/batch_queue.h"

namespace meristem {

/// A batch of instances after its expansion, before its children are placed.
struct ExpandedBatch {
  const Batch& batch;
  const BatchResult& result;
  const GrownBatch* grown = nullptr;  ///< grown plants of the instances; null for components that do not grow
  std::size_t per_block = kBlock;     ///< number of instances in each block of `result`; the last block may have fewer
  /// Expands the instance with this index in the batch once more, alone, and returns its parts. Only for components
  /// that do not grow.
  FunctionRef<Emitted(std::size_t instance)> expand_alone;
};

/// The children of a batch by one link, before they are expanded.
struct PlacedChildren {
  const Batch& parent;
  LinkIndex link = kNoIndex;
  const Batch& batch;  ///< the children, in the order of their parents; may be empty
  /// Number of children of each block of the parent's result. Empty if the sites come from the cache.
  std::span<const std::size_t> per_block{};
};

/// Receives the batches of a walk, one at a time and in an order that does not depend on threads.
class WalkVisitor {
 public:
  virtual ~WalkVisitor() = default;
  /// Receives the batch of the root before everything else.
  virtual void on_root(const Batch&) {}
  /// Receives each batch after its expansion. Parents come before their children.
  virtual void on_expanded(const ExpandedBatch&) {}
  /// Receives the children of a batch for each link that the walk follows, soon after the batch itself.
  virtual void on_children(const PlacedChildren&) {}
  /// Returns true if the visitor needs no further batches. The walk then stops. Batches that have grown together with
  /// the last one may still follow.
  virtual bool is_done() const { return false; }
};

}  // namespace meristem
