// SPDX-License-Identifier: Apache-2.0
// A growth of self-organizing trees, iteration by iteration. Their branches sag, are bent, shed and cut, so each step
// is kept as it was.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "meristem/grow/growth_trace.h"
#include "meristem/scene/marker/marker_field.h"

namespace meristem {

class OrganizeTrace : public GrowthTrace {
 public:
  /// What the trees of a component were after one iteration, all together.
  struct Step {
    Skeleton skeleton;            ///< where steps are asked for
    std::vector<TracedWay> ways;  ///< of the buds that grew in the iteration
  };

  /// The next step; the first one is step 0.
  void add(Step step) { steps_.push_back(std::move(step)); }
  /// Takes what all trees have lost, by rising step for each tree.
  void lose(std::vector<TracedLoss> losses);
  /// Shows the room of a tree, whose buds see markers up to `perception` metres away.
  void show_room(std::shared_ptr<const MarkerField> vacant, double perception);

  /// Takes how all trees stand after what they plan.
  void plan(Skeleton outcome) { outcome_ = std::move(outcome); }

  int last_step() const override { return static_cast<int>(steps_.size()) - 1; }
  Skeleton standing(int step, const Scene& scene, Progress& progress) const override;
  const Skeleton* outcome() const override { return outcome_ ? &*outcome_ : nullptr; }
  /// Ways, losses and markers. Markers are those that the component's own trees have taken or could see. Their time
  /// goes with the trees' size, and the square of how far buds see.
  StepMarks marks(int step, const TraceWish& wish) const override;
  std::uint64_t bytes() const override;

 private:
  std::vector<TracedPlace> markers(const Skeleton& skeleton) const;

  std::vector<Step> steps_;
  std::optional<Skeleton> outcome_;
  std::vector<TracedLoss> losses_;                         // by rising step
  std::vector<std::shared_ptr<const MarkerField>> rooms_;  // one for each tree; empty: no markers are shown
  double perception_ = 0;
};

}  // namespace meristem
