// SPDX-License-Identifier: Apache-2.0
// A growth of colonizing trees, step by step. Nodes never move and never go, so the nodes that were there after a step
// are the first ones, and the tree of that step is what is made of them; nothing is kept for each step but where
// points moved to.
#pragma once

#include <string>
#include <vector>

#include "meristem/grow/colonize/cloud_record.h"
#include "meristem/grow/colonize/colonizing_species.h"
#include "meristem/grow/growth_trace.h"

namespace meristem {

/// One tree: its nodes, relative to its root, as they have grown, and its points, relative to `origin`.
struct TracedTree {
  Vec3 root{0};
  Skeleton skeleton;  ///< births do not fall from node to node
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
  /// Points, and which of these trees' nodes they will pull next.
  StepMarks marks_of(int step, TraceWish wish, const Progress& progress) const override;
  std::vector<TracedWay> pulls(int step, const std::vector<TracedPlace>& points, const Progress& progress) const;

  ColonizeParameters parameters_;
  Limits limits_;
  std::string component_;
  std::vector<TracedTree> trees_;
  int steps_;
};

}  // namespace meristem
