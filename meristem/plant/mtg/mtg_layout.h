// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Returns true for each node that continues its parent's axis. Among several children on the axis, the first one does.
std::vector<bool> find_successors(const Skeleton& skeleton);

/// The place of a node in an MTG file.
struct MtgEntry {
  NodeIndex node = 0;
  std::uint8_t column = 0;    ///< column of its code, from 0
  bool is_successor = false;  ///< it continues its parent's axis
  bool stays = false;         ///< it is written in its parent's column
};

/// Orders the nodes of skeletons as lines of an MTG, one skeleton after another. Each node comes before the nodes that
/// it bears, and the child that stays in its column comes last. Branches of order k are in column k. If orders exceed
/// 63, the largest child stays in the column of its parent instead, so that there are at most 32 columns and lines stay
/// short. Throws Cancelled.
class MtgLayout {
 public:
  MtgLayout(std::span<const Skeleton* const> skeletons, const Progress& progress);

  const std::vector<MtgEntry>& places() const { return places_; }
  std::size_t column_count() const { return columns_; }

 private:
  void add(const Skeleton& skeleton, bool by_order, const Progress& progress);

  std::vector<MtgEntry> places_;
  std::size_t columns_ = 1;
};

}  // namespace meristem
