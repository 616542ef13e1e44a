// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Whether each node continues its parent's axis: of a node's children on its own axis, the first does.
std::vector<bool> find_successors(const Skeleton& skeleton);

/// A node's entry in an MTG file.
struct MtgEntry {
  NodeIndex node = 0;
  std::uint8_t column = 0;    ///< of its code, from 0
  bool is_successor = false;  ///< it continues its parent's axis
  bool stays = false;         ///< it stands in its parent's column
};

/// The nodes of skeletons in the order of an MTG's lines, one skeleton after the other: each node before what it bears,
/// and that which stays in its column last. Branches of order k stand in column k, unless orders go past 63; then the
/// largest of those that a node bears stays in its column, so that there are never more than 32. So the lines' length
/// is bounded. Throws Cancelled.
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
