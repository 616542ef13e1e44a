// SPDX-License-Identifier: Apache-2.0
// Expands the graph with a watching component type to find all instances, and then derives and draws the requested one.
#include "meristem/components/lsystem_trace.h"

#include <algorithm>
#include <mutex>
#include <tuple>
#include <utility>

#include "meristem/components/lsystem.h"
#include "meristem/graph/expand.h"
#include "meristem/grow/lsystem/derive.h"

namespace meristem {

namespace {

/// An instance, recorded during the expansion.
struct MetInstance {
  Lsystem plant;
  Site site;
  Directions directions;
};

/// Collects all instances. Thread-safe.
class MetInstances {
 public:
  void meet(const Lsystem& plant, const Site& site, const Directions& directions) {
    const std::lock_guard lock(mutex_);
    all_.push_back({plant, site, directions});
  }

  /// Returns all instances in an order that does not depend on threads.
  std::vector<MetInstance> take() {
    std::ranges::sort(all_, {}, rank);
    return std::move(all_);
  }

 private:
  static std::tuple<std::uint16_t, std::uint32_t, std::uint64_t> rank(const MetInstance& met) {
    return {met.site.depth, met.site.i, met.site.key.bits()};
  }

  std::mutex mutex_;
  std::vector<MetInstance> all_;
};

/// Returns the number of the requested instance.
std::size_t number_of(const std::vector<MetInstance>& all, const LsystemTraceRequest& request) {
  if (request.key) {
    const auto found = std::ranges::find(all, *request.key, [](const MetInstance& met) { return met.site.key.bits(); });
    if (found != all.end()) return static_cast<std::size_t>(found - all.begin());
  }
  return std::min(request.number, all.size() - 1);
}

/// Returns the component type with an expansion that records each instance in `met` and draws nothing.
ComponentType watched(const ComponentType& type, MetInstances& met) {
  ComponentType made = type;
  made.expand = [&met](const Prototype& prototype, std::span<const Site> sites, Emitter& out) {
    Lsystem instance = *static_cast<const Lsystem*>(prototype.parameters.get());
    const VaryingValues values(prototype.varyings, sites, out.document_time());
    for (std::size_t k = 0; k < sites.size(); ++k) {
      values.apply(k, &instance);
      out.instance(instance, sites[k], k, [&](const Site& site) {
        met.meet(instance, site, out.context().directions());
        out.sites().no_children();
      });
    }
  };
  return made;
}

Vec3 middle_of(const WordDrawing& drawing, const TurtlePolygon& polygon) {
  Vec3 sum(0);
  for (std::uint32_t k = 0; k < polygon.count; ++k) sum += drawing.corners[polygon.first + k];
  return sum / static_cast<float>(polygon.count);
}

std::vector<DrawnModule> places_of(const WordDrawing& drawing) {
  std::vector<DrawnModule> places;
  const Skeleton& skeleton = drawing.skeleton;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.is_root(node)) continue;
    places.push_back({drawing.module_of_node[node], skeleton.position[skeleton.parent[node]], skeleton.position[node]});
  }
  for (const TurtlePolygon& polygon : drawing.polygons)
    places.push_back({polygon.module, polygon.frame.origin, middle_of(drawing, polygon)});
  for (const TurtleSite& site : drawing.places) places.push_back({site.module, site.frame.origin, site.frame.origin});
  std::ranges::stable_sort(places, {}, &DrawnModule::module);
  return places;
}

}  // namespace

std::optional<LsystemTrace> trace_lsystem(const Graph& graph, const Scene& scene, const std::string& id,
                                          const LsystemTraceRequest& request, double time, Progress& progress) {
  const auto found = std::ranges::find(graph.components, id, &Prototype::id);
  if (found == graph.components.end() || found->type->name != lsystem_component().name) return std::nullopt;
  MetInstances met;
  const ComponentType type = watched(*found->type, met);
  Graph watching = graph;
  watching.components[static_cast<std::size_t>(found - graph.components.begin())].type = &type;
  expand(watching, scene, time, progress);
  const std::vector<MetInstance> all = met.take();
  if (all.empty()) return std::nullopt;

  const std::size_t number = number_of(all, request);
  const auto& [plant, site, directions] = all[number];
  const Grammar& grammar = plant.source().grammar;
  LsystemTrace trace{.site = site,
                     .number = number,
                     .count = all.size(),
                     .text = plant.source().text,
                     .steps = static_cast<int>(steps_of(plant)),
                     .alphabet = grammar.alphabet,
                     .derived = {},
                     .drawn = {},
                     .is_interpreted = !grammar.interpretation.rules.empty(),
                     .places = {}};
  try {
    const RandomKey key = word_key(site);
    const double wanted = request.steps ? *request.steps : steps_of(plant);
    trace.derived = derive(grammar, wanted, key, graph.limits, progress);
    trace.drawn = interpreted(grammar, trace.derived, key, graph.limits, progress);
    trace.places = places_of(draw(trace.drawn, grammar.alphabet, turtle_of(plant, directions), site.frame, graph.limits,
                                  "components." + id, progress));
  } catch (const InputError& error) {
    throw_placed(error, plant, id);
  }
  return trace;
}

}  // namespace meristem
