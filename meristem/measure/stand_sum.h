// SPDX-License-Identifier: Apache-2.0
// Adds up the measures of the trees of a stand, tree by tree.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/measure/forks.h"
#include "meristem/measure/measures.h"
#include "meristem/measure/tree_form.h"
#include "meristem/plant/skeleton.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// The measures of one tree.
struct TreeRecord {
  TreeForm form;  ///< the crown's hull is dropped
  ForkSamples forks;
  std::vector<std::uint64_t> streams;
  std::optional<double> lit_share;
  Vec3 position{0};  ///< position of the root, metres
};

/// Measures each tree of a skeleton, in the order of the roots. Throws Cancelled.
std::vector<TreeRecord> record_trees(const Skeleton& skeleton, const Scene* scene, const MeasureOptions& options,
                                     const Progress& progress);

/// Adds up the measures of the trees of a stand.
class StandSum {
 public:
  void add(const TreeRecord& tree);
  /// Returns the measures of the stand. Must be called once, after the last tree.
  Measures finish();

 private:
  Measures sums_;
  std::optional<TreeForm> tallest_;  // ties go to the first tree
  ForkSamples forks_;
  DVec3 segment_sum_{0};
  DVec3 node_sum_{0};
  double hull_area_ = 0;  // hull area of the trees whose lit share is known
  double lit_area_ = 0;
};

}  // namespace meristem
