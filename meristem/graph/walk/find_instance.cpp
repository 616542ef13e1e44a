// SPDX-License-Identifier: Apache-2.0
// Finds the instance that made a part of the plant. Parts of a component are numbered over its batches in order, so the
// parts of whole batches and blocks before the requested part are only counted. A block does not store which instance
// made a part. Each instance of the right block is therefore expanded once more, alone, until its parts include the
// requested one.
#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "meristem/graph/instances.h"
#include "meristem/graph/walk/walk.h"

namespace meristem {

namespace {

class FindVisitor final : public WalkVisitor {
 public:
  FindVisitor(const Graph& graph, double time, const InstanceQuery& query)
      : graph_(graph), time_(time), query_(query), ahead_(query.number) {}

  void on_expanded(const ExpandedBatch& expanded) override {
    const Prototype& prototype = graph_.components[expanded.batch.component];
    if (is_done_ || prototype.id != query_.component) return;
    const std::optional<std::size_t> instance =
        query_.of == InstanceQuery::Of::instance ? pass_instances(expanded.batch) : pass_parts(expanded);
    if (instance) found_ = describe(prototype, expanded.batch.site(*instance));
  }

  bool is_done() const override { return is_done_; }

  std::optional<FoundInstance> take_found() { return std::move(found_); }

 private:
  /// Returns the index of the requested instance in a batch. If it is not there, passes the batch.
  std::optional<std::size_t> pass_instances(const Batch& batch) {
    is_done_ = ahead_ < batch.count();
    if (is_done_) return static_cast<std::size_t>(ahead_);
    ahead_ -= batch.count();
    return std::nullopt;
  }

  /// Returns the index of the instance in a batch that made the requested part. If the part is not there, passes the
  /// batch.
  std::optional<std::size_t> pass_parts(const ExpandedBatch& expanded) {
    for (std::size_t k = 0; k < expanded.result.blocks.size(); ++k) {
      const std::uint64_t made = count_parts(expanded.result.blocks[k]);
      is_done_ = ahead_ < made;
      if (is_done_) return find_in_block(expanded, k * expanded.per_block);
      ahead_ -= made;
    }
    return std::nullopt;
  }

  /// Returns the index of the instance that made the requested part, in the block whose first instance is `first`.
  /// Returns nothing if no instance makes the part alone.
  std::optional<std::size_t> find_in_block(const ExpandedBatch& expanded, std::size_t first) {
    const std::size_t end = std::min(first + expanded.per_block, expanded.batch.count());
    if (end - first == 1) return first;
    for (std::size_t instance = first; instance < end; ++instance) {
      const std::uint64_t made = count_parts(expanded.expand_alone(instance));
      if (ahead_ < made) return instance;
      ahead_ -= made;
    }
    return std::nullopt;
  }

  /// Returns the number of parts of the requested kind.
  std::uint64_t count_parts(const Emitted& emitted) const {
    if (query_.of == InstanceQuery::Of::organ) return emitted.organs.size();
    return static_cast<std::uint64_t>(std::ranges::count_if(emitted.stems, &EmittedStem::visible));
  }

  FoundInstance describe(const Prototype& prototype, const Site& site) const {
    FoundInstance found{.site = site, .values = {}};
    const VaryingValues values(prototype.varyings, std::span(&site, 1), time_);
    for (std::size_t k = 0; k < prototype.varyings.size(); ++k) {
      found.values.emplace_back(prototype.varyings[k].path, values.value(k, 0) / prototype.varyings[k].scale);
    }
    return found;
  }

  const Graph& graph_;
  double time_;
  const InstanceQuery& query_;
  std::uint64_t ahead_;   // number of parts still to pass before the requested part
  bool is_done_ = false;  // the block of the requested part has been reached
  std::optional<FoundInstance> found_;
};

}  // namespace

std::optional<FoundInstance> find_instance(const Graph& graph, const Scene& scene, double time,
                                           const InstanceQuery& request, Progress& progress, Cache* cache,
                                           const GrowthView& view) {
  FindVisitor visitor(graph, time, request);
  Walk(graph, scene, time, progress, {.cache = cache, .view = view}).run(visitor);
  return visitor.take_found();
}

}  // namespace meristem
