// SPDX-License-Identifier: Apache-2.0
// The recorded growth of self-organizing trees. Branches sag, are bent, shed and cut, so each step is stored
// completely.
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

/// The space that the trees of a component compete for.
struct TracedRoom {
  MarkerField vacant;                  ///< the field without any shoots
  std::vector<std::uint32_t> volumes;  ///< volume of each tree in the field
  double perception = 0;               ///< metres up to which buds see markers
  std::uint64_t max_markers = SizeLimits().points;
  std::string path;  ///< document path of the markers' spacing, for the error about too many markers
};

class OrganizeTrace : public GrowthTrace {
 public:
  /// The state of all trees of a component after one iteration.
  struct Step {
    Skeleton skeleton;            ///< recorded if steps were requested
    std::vector<TracedWay> ways;  ///< directions of the buds that grew in the iteration
  };

  /// `seeks_room`: true if the buds' directions lead to more space, false if they lead to more light.
  explicit OrganizeTrace(bool seeks_room) : seeks_room_(seeks_room) {}

  /// Appends the next step, beginning with step 0.
  void add(Step step) { steps_.push_back(std::move(step)); }
  /// Sets the losses of all trees. Call it once.
  void lose(std::vector<TracedLoss> losses);
  /// Enables markers and sets the space of the trees.
  void show_room(TracedRoom room) { room_ = std::move(room); }

  /// Sets the state of all trees after their planned operations.
  void plan(Skeleton outcome) { outcome_ = std::move(outcome); }

  int last_step() const override { return static_cast<int>(steps_.size()) - 1; }
  const Skeleton* outcome() const override { return outcome_ ? &*outcome_ : nullptr; }
  std::uint64_t bytes() const override;

 private:
  Skeleton standing_after(int step, const Scene& scene, Progress& progress) const override;
  /// Returns directions, losses and markers. Markers are shown if the component's own trees have occupied or could see.
  /// Cost of markers: proportional to the nodes of the trees times the cube of the buds' range of vision.
  StepMarks marks_of(int step, TraceRequest request, const Progress& progress) const override;
  std::vector<TracedPlace> markers(const Skeleton& skeleton, const Progress& progress) const;

  bool seeks_room_;
  std::vector<Step> steps_;
  std::vector<TracedLoss> losses_;  // by rising step
  std::optional<TracedRoom> room_;  // unset: markers are not shown
  std::optional<Skeleton> outcome_;
};

}  // namespace meristem
