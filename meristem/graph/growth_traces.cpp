// SPDX-License-Identifier: Apache-2.0
// Combines the records of a graph's own plants and of placed plants of other documents. Marks of placed plants are
// copied to each position of the plant, up to a limit.
#include "meristem/graph/growth_traces.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"

namespace meristem {

namespace {

constexpr std::size_t kMaxPlacedMarks = 4'000'000;  // all places together: about 200 MB as overlays

/// Places the marks of placed plants at each of their positions, and counts them.
class PlacedMarks {
 public:
  explicit PlacedMarks(const Progress& progress) : progress_(progress) {}

  /// Adds the marks of a plant once for each position where it stands.
  void add(const PlacedTraces& placed, const std::vector<GrowthMarks>& of_plant, std::vector<GrowthMarks>& all) {
    for (const Frame& frame : placed.frames) {
      for (const GrowthMarks& growth : of_plant) {
        progress_.check();
        const std::string component = placed.component + "." + growth.component;
        count_ += growth.marks.count();
        if (count_ > kMaxPlacedMarks) throw_too_many(placed.component);
        all.push_back({component, next_[component]++, growth.marks});
        all.back().marks.move(frame);
      }
    }
  }

 private:
  [[noreturn]] static void throw_too_many(const std::string& component) {
    throw InputError(Diagnostic{
        .message = fmt::format("the plants of other documents grew by more than {} points and ways", kMaxPlacedMarks),
        .expected = "fewer of these plants, or the overlays of one of them in its own document",
        .path = "components." + component});
  }

  const Progress& progress_;
  std::size_t count_ = 0;
  std::map<std::string, std::uint32_t> next_;  // number of the next growth, by component
};

}  // namespace

int GrowthTraces::shown_step() const { return std::clamp(step.value_or(last_step), 0, last_step); }

void GrowthTraces::add_steps(const std::string& component, int last, const GrowthView& view) {
  if (last <= 0) return;
  const auto place = std::ranges::lower_bound(steps, component, {}, &ComponentSteps::component);
  const bool is_known = place != steps.end() && place->component == component;
  ComponentSteps& own = is_known ? *place : *steps.insert(place, {component, 0});
  own.last_step = std::max(own.last_step, last);
  if (is_looked_at(view, component)) last_step = std::max(last_step, last);
}

StepMarks GrowthTraces::marks(int of_step, TraceRequest request, const Progress& progress) const {
  StepMarks marks;
  for (GrowthMarks& growth : marks_of_growths(of_step, request, progress)) marks.append(std::move(growth.marks));
  return marks;
}

std::vector<GrowthMarks> GrowthTraces::marks_of_growths(int of_step, TraceRequest request,
                                                        const Progress& progress) const {
  const auto step_for = [&](const std::string& component) {
    return of.empty() || of == component ? of_step : std::numeric_limits<int>::max();
  };
  std::vector<GrowthMarks> all;
  for (const TracedGrowth& growth : growths) {
    const int own = step_for(growth.component);
    all.push_back({growth.component, growth.instance, growth.trace->marks(own, request, progress)});
  }
  PlacedMarks at_places(progress);
  for (const PlacedTraces& plant : placed) {
    // The recursion is as deep as documents lie within each other.
    at_places.add(plant, plant.traces->marks_of_growths(step_for(plant.component), request, progress), all);
  }
  return all;
}

bool GrowthTraces::has_growths() const {
  return !growths.empty() ||
         std::ranges::any_of(placed, [](const PlacedTraces& plant) { return plant.traces->has_growths(); });
}

std::uint64_t GrowthTraces::bytes() const {
  std::uint64_t sum = 0;
  for (const TracedGrowth& growth : growths) sum += growth.trace->bytes();
  for (const PlacedTraces& plant : placed) sum += plant.traces->bytes() + plant.frames.size() * sizeof(Frame);
  return sum;
}

}  // namespace meristem
