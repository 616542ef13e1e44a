// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meristem/grow/growth_trace.h"

namespace meristem {

/// Which step of the growth of its plants a graph shows, and what is recorded of that growth.
struct GrowthView {
  /// All plants that grow by a model stand as after this step, or after their last one where that comes before; the
  /// steps of an L-system are those of its derivation. So they stand as they would with no more iterations, whatever
  /// the clock says. The growth is recorded, so that a cache gives all steps of one growth. Unset: after the last one.
  std::optional<int> step;
  TraceWish wish;  ///< parts of the growth to record
  /// Plants that only plan stand as after what they plan. A view that merely wishes for the outcome to be recorded
  /// shows them before it; with a cache both views come of one growth. Without meaning where there is a step.
  bool outcome = false;
  /// Id of the component whose plants alone `step` is for, as they have grown or as it places them; all others have
  /// grown to their end. Empty: all plants.
  std::string of{};

  bool operator==(const GrowthView&) const = default;
};

/// Whether the step of a view is for the plants of a component.
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

/// What was recorded of a plant of another document, and where it stands.
struct PlacedTraces {
  std::string component;      ///< id of the component that places it
  std::vector<Frame> frames;  ///< from its world to the world, one for each place; without what deforms it there
  std::shared_ptr<const GrowthTraces> traces;  ///< records of the plant's own growths
};

/// How many steps the plants of one component take.
struct ComponentSteps {
  std::string component;  ///< id; it grows plants, or places plants of other documents
  int last_step = 0;      ///< the most of them

  bool operator==(const ComponentSteps&) const = default;
};

/// The marks of one growth.
struct GrowthMarks {
  std::string component;       ///< id; within placed plants with the ids that lead there: "oak.tree"
  std::uint32_t instance = 0;  ///< number among the growths of that component
  StepMarks marks;             ///< the marks
};

/// What was recorded of a graph's plants.
struct GrowthTraces {
  std::vector<TracedGrowth> growths;  ///< of its own plants
  std::vector<PlacedTraces> placed;   ///< of plants of other documents, each once for all of its places
  std::vector<ComponentSteps> steps;  ///< of all components whose plants take any, by their ids
  int last_step = 0;                  ///< of all plants that the view's step is for; 0 where none grows by a model
  std::optional<int> step;            ///< that these plants stand at; unset: their last
  std::string of{};                   ///< GrowthView::of: id of the component whose plants `step` is for; empty: all
  TraceWish recorded;                 ///< what was asked to be recorded, whether or not there was such a thing

  /// Takes account of plants of a component that take that many steps; `view` is what they are shown by.
  void add_steps(const std::string& component, int last, const GrowthView& view);
  /// The step that the plants stand at, 0 to last_step.
  int shown_step() const;

  /// What is known of one step of all plants that the view's step is for, of those in their places, too; of a plant
  /// that has ended before, and of all others, its last step's. Throws as GrowthTrace::marks(), and InputError where
  /// placed plants have more than 4 million marks.
  StepMarks marks(int of_step, TraceWish wish, const Progress& progress) const;
  /// Returns the marks of each growth: first the growths of the document in their order, then the growths of placed
  /// plants, place by place.
  std::vector<GrowthMarks> marks_of_growths(int of_step, TraceWish wish, const Progress& progress) const;
  bool has_growths() const;     ///< whether anything was recorded of any plant
  std::uint64_t bytes() const;  ///< memory of all records
};

}  // namespace meristem
