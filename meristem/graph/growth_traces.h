// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meristem/grow/growth_trace.h"

namespace meristem {

/// The growth step at which a graph shows its plants, and the parts of their growth to record.
struct GrowthView {
  /// All plants that grow by a model are shown after this step, or after their last step if that comes earlier. The
  /// steps of an L-system are the steps of its derivation. The plants look as if they had no more iterations, whatever
  /// the clock shows. The growth is recorded, so that a cache gives all steps of one growth. Unset: the last step.
  std::optional<int> step;
  TraceRequest request;  ///< parts of the growth to record
  /// If true, plants in plan mode are shown after their planned operations. A view that only records the outcome shows
  /// them before. With a cache, both views share one growth. Has no effect if `step` is set.
  bool outcome = false;
  /// Id of the component whose plants `step` applies to: plants that it grows or places. All other plants are fully
  /// grown. Empty: all plants.
  std::string of{};

  bool operator==(const GrowthView&) const = default;
};

/// Returns true if the step of a view applies to the plants of a component.
inline bool is_looked_at(const GrowthView& view, const std::string& component) {
  return view.of.empty() || view.of == component;
}

/// The growth of one instance of a component.
struct TracedGrowth {
  std::string component;                     ///< id
  std::uint32_t instance = 0;                ///< number among the component's instances
  std::shared_ptr<const GrowthTrace> trace;  ///< the record; not null
};

struct GrowthTraces;

/// The records of a plant of another document, and the frames at which it stands.
struct PlacedTraces {
  std::string component;      ///< id of the component that places it
  std::vector<Frame> frames;  ///< one frame per position, from the plant's world to the world, without deformations
  std::shared_ptr<const GrowthTraces> traces;  ///< records of the plant's own growths
};

/// The number of steps that the plants of one component take.
struct ComponentSteps {
  std::string component;  ///< id; it grows plants, or places plants of other documents
  int last_step = 0;      ///< the largest number of steps among them

  bool operator==(const ComponentSteps&) const = default;
};

/// The marks of one growth.
struct GrowthMarks {
  std::string component;       ///< id; for placed plants, the ids that lead there: "oak.tree"
  std::uint32_t instance = 0;  ///< number among the growths of that component
  StepMarks marks;             ///< the marks
};

/// The records of the growth of a graph's plants.
struct GrowthTraces {
  std::vector<TracedGrowth> growths;  ///< of its own plants
  std::vector<PlacedTraces> placed;   ///< records of plants of other documents; each is listed once with all of its
                                      ///< positions
  std::vector<ComponentSteps> steps;  ///< all components whose plants take any steps, sorted by id
  int last_step = 0;                  ///< last step of all plants that the view's step applies to; 0 if none grows by a
                                      ///< model
  std::optional<int> step;            ///< step at which these plants are shown; unset: their last
  std::string of{};                   ///< GrowthView::of: id of the component whose plants `step` is for; empty: all
  TraceRequest recorded;              ///< the requested records, even if no plant has such parts

  /// Registers that plants of a component take `last` steps; `view` is the view that shows them.
  void add_steps(const std::string& component, int last, const GrowthView& view);
  /// Returns the step at which the plants are shown, 0 to last_step.
  int shown_step() const;

  /// Returns the marks of one step of all plants that the view's step applies to, including placed plants. A plant that
  /// has ended earlier, and every other plant, contributes its last step. Throws as GrowthTrace::marks(), and
  /// InputError if placed plants have more than 4 million marks.
  StepMarks marks(int of_step, TraceRequest request, const Progress& progress) const;
  /// Returns the marks of each growth: first the growths of the document in their order, then the growths of placed
  /// plants, place by place.
  std::vector<GrowthMarks> marks_of_growths(int of_step, TraceRequest request, const Progress& progress) const;
  bool has_growths() const;     ///< whether anything was recorded of any plant
  std::uint64_t bytes() const;  ///< memory of all records
};

}  // namespace meristem
