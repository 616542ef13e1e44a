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
  TraceWish wish;
  /// Plants that only plan stand as after what they plan. A view that merely wishes for the outcome to be recorded
  /// shows them before it; with a cache both views come of one growth. Without meaning where there is a step.
  bool outcome = false;

  bool operator==(const GrowthView&) const = default;
};

/// The growth of one instance of a component.
struct TracedGrowth {
  std::string component;       ///< id
  std::uint32_t instance = 0;  ///< number among the component's instances
  std::shared_ptr<const GrowthTrace> trace;
};

/// What was recorded of a graph's plants.
struct GrowthTraces {
  std::vector<TracedGrowth> growths;
  int last_step = 0;        ///< of all plants; 0 where none grows by a model
  std::optional<int> step;  ///< that the plants stand at; unset: their last
  TraceWish recorded;       ///< what was asked to be recorded, whether or not there was such a thing

  /// The step that the plants stand at, 0 to last_step.
  int shown_step() const;

  /// What is known of one step of all plants; of a plant that has ended before, its last step's.
  /// Throws as GrowthTrace::marks().
  StepMarks marks(int of_step, TraceWish wish, const Progress& progress) const;
  std::uint64_t bytes() const;
};

}  // namespace meristem
