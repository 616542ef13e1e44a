// SPDX-License-Identifier: Apache-2.0
// Grows the plants of other documents that the instances of this one place. Requests for equal plants are grown once.
// Different plants grow in parallel, and plants of the previous run are reused if a cache has them.
#include "meristem/graph/grow_plantings.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <set>
#include <tuple>
#include <unordered_map>

#include <fmt/format.h>

#include "meristem/base/fingerprint.h"
#include "meristem/base/parallel.h"
#include "meristem/graph/vanished.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

namespace {

constexpr std::uint64_t kMaxPlants =
    10'000;  // counts the plants within plants, too; each takes at least some tens of kilobytes

std::uint64_t key_of(const Emitted::PlacedPlant& plant, const std::optional<int>& step) {
  Fingerprint key;
  key.add(plant.source->fingerprint()).add(plant.request.seed).add(plant.request.time);
  for (const auto& [name, value] : plant.request.values) key.add_text(name).add(value);
  if (step) key.add(*step).add_text("step");
  return key.hash();
}

/// A plant that is grown once, for all requests that are equal.
struct Wanted {
  const Emitted::PlacedPlant* plant = nullptr;
  ComponentIndex component = 0;
  std::uint64_t key = 0;                   // key of the plant as it is shown
  std::uint64_t growth_key = 0;            // key of what all steps of its growth share
  std::shared_ptr<PlacedGrowth> growth{};  // the growth, if the cache keeps it
  std::shared_ptr<const PlantVariant> grown{};
  std::shared_ptr<const GrowthTraces> traces{};
};

/// The memory of a plant and of the plants within it. Each different plant counts once.
struct Held {
  std::uint64_t plants = 0;
  std::uint64_t nodes = 0;
  std::uint64_t organs = 0;
};

Held held_by(const Plant& plant) {
  Held held{1, plant.node_count(), plant.organs.size()};
  std::set<const PlantVariant*> seen;
  for (const Planting& planting : plant.plantings) {
    if (!seen.insert(planting.variant.get()).second) continue;
    // The recursion is as deep as documents lie within each other
    const Held within = held_by(*planting.variant->plant);
    held.plants += within.plants;
    held.nodes += within.nodes;
    held.organs += within.organs;
  }
  return held;
}

/// Returns a request as text: "components.oak grows 'oak' with age = 40 and seed 7".
std::string told(const Wanted& wanted) {
  std::string with;
  for (const auto& [name, value] : wanted.plant->request.values) with += fmt::format("{} = {:.6g}, ", name, value);
  return fmt::format("'{}' with {}seed {}", wanted.plant->source->file(), with, wanted.plant->request.seed);
}

class PlantingGrower {
 public:
  PlantingGrower(const Graph& graph, const GrowthView& view, CacheRun& results, Progress& progress)
      : graph_(graph),
        view_(view),
        request_(view.request.without(TracePart::outcome)),
        results_(results),
        progress_(progress) {}

  std::vector<Planting> run(const std::vector<PlantingBatch>& batches, GrowthTraces* traces) {
    for (const PlantingBatch& batch : batches) {
      for (const Emitted& block : batch.result->blocks) {
        for (const Emitted::PlacedPlant& plant : block.plants) add(plant, batch.component);
      }
    }
    grow_all();
    for (std::size_t k = 0; k < plantings_.size(); ++k) {
      plantings_[k].variant = wanted_[variant_of_[k]].grown;
      if (traces != nullptr) take_traces(plantings_[k], wanted_[variant_of_[k]].traces, *traces);
    }
    return std::move(plantings_);
  }

 private:
  const std::string& id(ComponentIndex component) const { return graph_.components[component].id; }

  /// Passes on what was recorded of a plant's growth.
  void take_traces(const Planting& planting, const std::shared_ptr<const GrowthTraces>& of_plant,
                   GrowthTraces& traces) const {
    if (of_plant == nullptr) return;
    PlacedTraces placed{planting.component, {}, of_plant};
    for (const Planting::Place& place : planting.places) placed.frames.push_back(place.frame);
    traces.placed.push_back(std::move(placed));
    traces.add_steps(planting.component, of_plant->last_step, view_);
  }

  /// Returns the view that shows the plants of a component.
  GrowthView view_for(ComponentIndex component) const {
    return {is_looked_at(view_, id(component)) ? view_.step : std::nullopt, request_};
  }

  void add(const Emitted::PlacedPlant& plant, ComponentIndex component) {
    const std::uint32_t instance = instances_[component]++;
    if (!plant.is_visible || has_vanished(plant.frame)) return;
    const std::optional<int> step = view_for(component).step;
    const std::uint64_t key = key_of(plant, step);
    const auto [known, is_new] = wanted_by_key_.try_emplace(key, wanted_.size());
    if (is_new) {
      // Two components may show the same plant at different steps.
      const std::uint64_t growth_key =
          Fingerprint().add(key_of(plant, {})).add(request_.bits()).add_text(id(component)).hash();
      wanted_.push_back({&plant, component, key, growth_key});
      if (wanted_.size() > kMaxVariants) throw_too_many(component);
    }
    const auto [place, is_first] =
        planting_of_.try_emplace({component, known->second, plant.deformation.get()}, plantings_.size());
    if (is_first) {
      plantings_.push_back({id(component), nullptr, {}, plant.deformation});
      variant_of_.push_back(known->second);
    }
    plantings_[place->second].places.push_back({plant.frame, instance, plant.birth, plant.row, plant.name});
  }

  [[noreturn]] void throw_too_many(ComponentIndex component) const {
    throw InputError(
        Diagnostic{.message = fmt::format("there are more than {} different plants of other documents", kMaxVariants),
                   .expected = fmt::format("at most {}: \"variants\" in '{}', or rounded values in its \"set\"",
                                           kMaxVariants, id(component)),
                   .path = "components." + id(component)});
  }

  /// Grows all plants. If several fail, throws the fault of the first one in their order, whatever the threads do. The
  /// plants after it are not grown: documents within documents would make each level repeat the failure of the level
  /// below.
  void grow_all() {
    progress_.begin("growing plants", wanted_.size());
    std::vector<std::exception_ptr> errors(wanted_.size());
    std::atomic<std::uint64_t> plants{0}, nodes{0}, organs{0};
    std::atomic<std::size_t> first_error{wanted_.size()};
    std::mutex storing;
    for (Wanted& wanted : wanted_) find(wanted);
    parallel_for(wanted_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        if (k > first_error) return;
        if (plants > kMaxPlants || nodes > graph_.limits.nodes || organs > graph_.limits.instances) return;
        try {
          if (wanted_[k].grown == nullptr) {
            grow(wanted_[k]);
            // Stored at once: if the growth is cancelled, the next run finds the plant.
            const std::lock_guard lock(storing);
            store(wanted_[k]);
          }
          const Held held = held_by(*wanted_[k].grown->plant);
          plants += held.plants;
          nodes += held.nodes;
          organs += held.organs;
        } catch (const InputError&) {
          errors[k] = std::current_exception();
          for (std::size_t known = first_error; k < known && !first_error.compare_exchange_weak(known, k);) {
          }
        }
        progress_.advance();
      }
    });
    for (const std::exception_ptr& error : errors) {
      if (error) std::rethrow_exception(error);
    }
    require_at_most(plants, "plants in them", kMaxPlants, "");
    require_at_most(nodes, "nodes", graph_.limits.nodes, " (limits.nodes)");
    require_at_most(organs, "leaves and other organs", graph_.limits.instances, " (limits.instances)");
  }

  void store(const Wanted& wanted) {
    if (wanted.growth != nullptr) results_.store(wanted.growth_key, wanted.growth);
    results_.store(wanted.key, std::const_pointer_cast<PlantVariant>(wanted.grown));
  }

  /// Looks for a plant of the previous run. A kept growth gives the plant at any step.
  void find(Wanted& wanted) {
    if (is_kept(wanted)) {
      wanted.growth = results_.find<PlacedGrowth>(wanted.growth_key);
    } else {
      wanted.grown = results_.find<const PlantVariant>(wanted.key);
    }
    results_.count<PlantVariant>(wanted.growth != nullptr || wanted.grown != nullptr);
  }

  bool is_kept(const Wanted& wanted) const { return request_.any() || view_for(wanted.component).step; }

  void require_at_most(std::uint64_t count, const char* what, std::uint64_t limit, const char* limit_name) const {
    if (count <= limit) return;
    throw InputError(
        Diagnostic{.message = fmt::format("the plants of other documents have more than {} {}", limit, what),
                   .expected = fmt::format("fewer \"variants\", or smaller plants{}", limit_name),
                   .path = "components." + id(wanted_.front().component)});
  }

  void grow(Wanted& wanted) const {
    const Progress part(&progress_);
    try {
      const std::shared_ptr<PlacedGrowth> growth =
          wanted.growth != nullptr ? wanted.growth : wanted.plant->source->plant(wanted.plant->request);
      const ShownPlant shown = growth->show(view_for(wanted.component), part);
      auto variant = std::make_shared<PlantVariant>(*shown.plant);
      variant->key = wanted.key;
      wanted.grown = std::move(variant);
      if (!is_kept(wanted)) return;
      wanted.growth = growth;
      wanted.traces = shown.traces;
    } catch (const InputError& error) {
      // The fault's own position lies in the other document; here the fault is placed at the component that requests
      // the plant.
      std::vector<Diagnostic> errors;
      for (const Diagnostic& found : error.diagnostics()) {
        if (found.severity != Severity::error) continue;
        errors.push_back({.message = fmt::format("growing {}: {}", told(wanted), found.text()),
                          .path = "components." + id(wanted.component)});
      }
      throw InputError(std::move(errors));
    }
  }

  const Graph& graph_;
  const GrowthView& view_;
  const TraceRequest request_;  // parts of the growth to record of each plant
  CacheRun& results_;
  Progress& progress_;
  std::vector<Wanted> wanted_;
  std::unordered_map<std::uint64_t, std::size_t> wanted_by_key_;
  std::map<std::tuple<ComponentIndex, std::size_t, const Deformation*>, std::size_t> planting_of_;
  std::vector<Planting> plantings_;
  std::vector<std::size_t> variant_of_;  // for each planting: its index in `wanted_`
  std::map<ComponentIndex, std::uint32_t> instances_;
};

}  // namespace

std::vector<Planting> grow_plantings(const Graph& graph, std::vector<PlantingBatch> batches, const GrowthView& view,
                                     GrowthTraces* traces, CacheRun& results, Progress& progress) {
  if (batches.empty()) return {};
  std::stable_sort(batches.begin(), batches.end(),
                   [](const PlantingBatch& a, const PlantingBatch& b) { return a.component < b.component; });
  return PlantingGrower(graph, view, results, progress).run(batches, traces);
}

}  // namespace meristem
