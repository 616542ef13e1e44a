// SPDX-License-Identifier: Apache-2.0
// A growth of self-organizing trees, iteration by iteration. Their branches sag, are bent, shed and cut, so each step
// is kept as it was.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/grow/growth_trace.h"
#include "meristem/scene/marker/marker_field.h"

namespace meristem {

/// The room that the trees of a component compete for.
struct TracedRoom {
  MarkerField vacant;                  ///< as it is without any shoots
  std::vector<std::uint32_t> volumes;  ///< of each tree, in it
  double perception = 0;               ///< metres up to which buds see markers
  std::uint64_t most_markers = Limits().points;
  std::string path;  ///< of the markers' spacing in the document, at which too many are a fault
};

class OrganizeTrace : public GrowthTrace {
 public:
  /// What the trees of a component were after one iteration, all together.
  struct Step {
    Skeleton skeleton;            ///< where steps are asked for
    std::vector<TracedWay> ways;  ///< of the buds that grew in the iteration
  };

  /// `seeks_room`: the buds' ways lead to more room, not to more light.
  explicit OrganizeTrace(bool seeks_room) : seeks_room_(seeks_room) {}

  /// The next step; the first one is step 0.
  void add(Step step) { steps_.push_back(std::move(step)); }
  /// Takes what all trees have lost; to be called once.
  void lose(std::vector<TracedLoss> losses);
  /// Shows the markers of the trees' room.
  void show_room(TracedRoom room) { room_ = std::move(room); }

  /// Takes how all trees stand after what they plan.
  void plan(Skeleton outcome) { outcome_ = std::move(outcome); }

  int last_step() const override { return static_cast<int>(steps_.size()) - 1; }
  const Skeleton* outcome() const override { return outcome_ ? &*outcome_ : nullptr; }
  std::uint64_t bytes() const override;

 private:
  Skeleton standing_after(int step, const Scene& scene, Progress& progress) const override;
  /// Ways, losses and markers. Markers are those that the component's own trees have taken or could see. Their time
  /// goes with the trees' nodes, and the cube of how far buds see.
  StepMarks marks_of(int step, TraceWish wish, const Progress& progress) const override;
  std::vector<TracedPlace> markers(const Skeleton& skeleton, const Progress& progress) const;

  bool seeks_room_;
  std::vector<Step> steps_;
  std::vector<TracedLoss> losses_;  // by rising step
  std::optional<TracedRoom> room_;  // none: no markers are shown
  std::optional<Skeleton> outcome_;
};

}  // namespace meristem
