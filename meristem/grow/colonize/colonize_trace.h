// SPDX-License-Identifier: Apache-2.0
// The recorded growth of colonizing trees. Nodes never move or disappear, so the nodes after a step are the first ones
// of the final list. The tree of a step is finished from these nodes. Only the positions of moving points are stored
// for each step.
#pragma once

#include <string>
#include <vector>

#include "meristem/grow/colonize/cloud_record.h"
#include "meristem/grow/colonize/colonizing_species.h"
#include "meristem/grow/growth_trace.h"

namespace meristem {

/// One tree: its raw nodes relative to its root, and its points relative to `origin`.
struct TracedTree {
  Vec3 root{0};
  Skeleton skeleton;  ///< births never fall from node to node
  PointHistory points;
  Vec3 origin{0};
};

class ColonizeTrace : public GrowthTrace {
 public:
  ColonizeTrace(const ColonizingSpecies& species, std::vector<TracedTree> trees, int steps);

  int last_step() const override { return steps_; }
  std::uint64_t bytes() const override;

 private:
  Skeleton standing_after(int step, const Scene& scene, Progress& progress) const override;
  /// Returns the points, and the pulls on these trees' nodes in the next step.
  StepMarks marks_of(int step, TraceRequest request, const Progress& progress) const override;
  std::vector<TracedWay> pulls(int step, const std::vector<TracedPlace>& points, const Progress& progress) const;

  ColonizeParameters parameters_;
  SizeLimits limits_;
  std::string component_;
  std::vector<TracedTree> trees_;
  int steps_;
};

}  // namespace meristem
