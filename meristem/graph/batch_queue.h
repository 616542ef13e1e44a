// SPDX-License-Identifier: Apache-2.0
// Decides which instances an expansion expands next. Keeps their results in an order that does not depend on this
// decision.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "meristem/graph/batch.h"
#include "meristem/graph/graph.h"

namespace meristem {

struct Way;

/// Instances of one component that expand together.
struct Batch {
  ComponentIndex component = 0;
  std::shared_ptr<const Sites> places;
  std::uint64_t first = 0;  ///< number of the first instance among all instances; valid if no batch is in slices
  Way* way = nullptr;       ///< null: the batch expands whole
  std::size_t begin = 0;    ///< index of the first site in `places`
  std::size_t end = places == nullptr ? 0 : places->sites.size();

  std::size_t count() const { return end - begin; }                       ///< number of instances
  Site site(std::size_t k) const { return places->sites.at(begin + k); }  ///< site of the k-th instance
  /// Calls `receive(site)` for the sites of all instances in their order.
  template <class Receive>
  void read(const Receive& receive) const {
    places->sites.read(begin, end, receive);
  }
};

/// The result of one batch.
struct FinishedBatch {
  ComponentIndex component = 0;
  std::shared_ptr<const BatchResult> result;
  BatchResult* own = nullptr;  ///< the result if nobody else reads it; else null
};

/// All instances of one component that the same sequence of links leads to from the root, made since the last growth.
struct Way {
  ComponentIndex component = 0;
  std::vector<FinishedBatch> made{};                 ///< in the order of the instances
  std::vector<std::pair<LinkIndex, Way*>> onward{};  ///< in the order of the links
  SiteList waiting{};                                ///< sites of instances that grow
  std::size_t sites = 0;                             ///< number of sites expanded so far
  std::size_t offered = 0;                           ///< number of sites for the children of these
};

/// The order in which batches expand. Components that grow wait until no other batch is left.
///
/// In slices, the descendants of some instances of a batch expand before the other instances of the batch, so that few
/// sites are in memory. Results come out in the order of whole batches, in slices or not.
class BatchQueue {
 public:
  /// `graph` must outlive the queue.
  explicit BatchQueue(const Graph& graph) : graph_(graph) {}

  /// Adds the batch of the root. Must be called first. `in_slices` is false for expansions whose batches must be whole.
  void begin(Batch root, bool in_slices);

  bool has_ready() const { return !ready_.empty(); }
  /// Removes the next batch that need not grow and returns it: at most as many instances as have about 65,536 children.
  /// There must be one (has_ready).
  Batch next();
  /// Removes all batches that wait for their growth and returns them, sorted by component. No batch may be ready.
  std::vector<Batch> take_growing();

  /// Returns the batch of the children that `link` places for `parent`, without adding it.
  Batch children(const Batch& parent, LinkIndex link, std::shared_ptr<const Sites> places);
  /// Adds a batch from `children`. Does nothing if it has no instances.
  void add(Batch children);
  /// Ends a batch: stores its result and makes the batches added since the last call ready. In slices they come before
  /// all others.
  void finish(const Batch& batch, std::shared_ptr<const BatchResult> result, BatchResult* own);

  /// Returns the results of all finished batches. Valid once take_growing has returned none.
  std::vector<FinishedBatch> take_results();

 private:
  Way* new_way(ComponentIndex component);
  Way* way_onward(const Batch& parent, LinkIndex link);
  void gather_ways();

  const Graph& graph_;
  bool in_slices_ = false;
  std::deque<Way> ways_;       // made since the last growth; their addresses stay valid
  std::vector<Way*> roots_{};  // ways from the root or from a component that grows
  std::deque<Batch> ready_;
  std::vector<Batch> growing_;
  std::vector<Batch> added_;  // batches that the unfinished batch has added, in slices
  std::vector<FinishedBatch> results_;
};

}  // namespace meristem
