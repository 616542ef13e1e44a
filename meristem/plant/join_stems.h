// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/plant/plant.h"

namespace meristem {

/// A stem as it was made, and where on which other one it grows.
struct LooseStem {
  StemPart part;
  std::shared_ptr<const Skeleton> skeleton;         ///< not null
  std::uint32_t parent = kNoStem;                   ///< an earlier stem of the list
  NodeIndex node = 0;                               ///< on its segment that ends in this node
  float along = 1;                                  ///< at this share of it
  std::vector<std::uint32_t> individual_of_root{};  ///< as in Stem; not asked for stems that join others
  std::uint64_t name = 0;                           ///< of which the names of its axes are made
  /// What each of its axes is numbered by in its name; empty: its own number.
  std::vector<AxisIndex> number_of_axis{};
};

/// Joins stems to those that they grow on: the parent gets a node where children spring, their roots give way to it,
/// and their axes become laterals of the parent's, of orders counted on from there. Stems with several roots or none,
/// and those that begin farther from their site than `reach` radii of the parent there, stay on their own.
///
/// Stems come out in the order of their roots in the list; axes are numbered by their first nodes. Cost linear but for
/// the sorting of children along a segment.
std::vector<Stem> join_stems(std::vector<LooseStem> stems, float reach = 3);

}  // namespace meristem
