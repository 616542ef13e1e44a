// SPDX-License-Identifier: Apache-2.0
// Collects the clocks that components begin for their descendants. Children inherit the clock of their site, so the
// sites of the children of such a component have its clocks. Equal clocks of neighbouring sites are collected once, and
// all others are removed by sorting.
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "meristem/graph/instances.h"
#include "meristem/graph/walk/walk.h"

namespace meristem {

namespace {

class ClockVisitor final : public WalkVisitor {
 public:
  explicit ClockVisitor(const Graph& graph) : graph_(graph) {}

  void on_children(const PlacedChildren& children) override {
    const ComponentIndex component = children.parent.component;
    if (!graph_.components[component].type->begins_clock) return;
    std::optional<InstanceClock> last;
    children.batch.read([&](const Site& site) {
      const bool is_new = !last || last->start != site.clock.start || last->speed != site.clock.speed;
      last = site.clock;
      if (is_new && std::isfinite(site.clock.start)) clocks_.push_back({component, site.clock});
    });
  }

  /// Returns the clocks, sorted and without duplicates.
  std::vector<BegunClock> take_clocks() {
    const auto rank = [](const BegunClock& one) { return std::tuple(one.component, one.clock.start, one.clock.speed); };
    std::ranges::sort(clocks_, {}, rank);
    const auto is_same = [&](const BegunClock& one, const BegunClock& other) { return rank(one) == rank(other); };
    clocks_.erase(std::unique(clocks_.begin(), clocks_.end(), is_same), clocks_.end());
    return std::move(clocks_);
  }

 private:
  const Graph& graph_;
  std::vector<BegunClock> clocks_;
};

}  // namespace

std::vector<BegunClock> begun_clocks(const Graph& graph, const Scene& scene, double time, Progress& progress,
                                     Cache* cache, const GrowthView& view) {
  ClockVisitor visitor(graph);
  Walk(graph, scene, time, progress, {.cache = cache, .view = view}).run(visitor);
  return visitor.take_clocks();
}

}  // namespace meristem
