// SPDX-License-Identifier: Apache-2.0
// Counts the instances of each component. The site of an instance decides whether the instance is omitted.
#include <utility>

#include "meristem/graph/instances.h"
#include "meristem/graph/omission.h"
#include "meristem/graph/walk/walk.h"

namespace meristem {

namespace {

class CountVisitor final : public WalkVisitor {
 public:
  CountVisitor(const Graph& graph, double time) : graph_(graph), time_(time), counts_(graph.components.size()) {}

  void on_expanded(const ExpandedBatch& expanded) override {
    const ComponentIndex component = expanded.batch.component;
    const ComponentBase& base = graph_.components[component].base();
    expanded.batch.read([&](const Site& site) {
      if (!is_left_out(base, site, time_)) ++counts_[component];
    });
  }

  std::vector<std::uint64_t> take_counts() { return std::move(counts_); }

 private:
  const Graph& graph_;
  double time_;
  std::vector<std::uint64_t> counts_;  // by component
};

}  // namespace

std::vector<std::uint64_t> instance_counts(const Graph& graph, const Scene& scene, double time, Progress& progress,
                                           Cache* cache, const GrowthView& view) {
  CountVisitor visitor(graph, time);
  Walk(graph, scene, time, progress, {.cache = cache, .view = view}).run(visitor);
  return visitor.take_counts();
}

}  // namespace meristem
