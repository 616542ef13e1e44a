// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// The further column in which a growth model numbers its metamers: along an axis from 1 at its base, 0 at a root. All
/// nodes of one metamer have its number. Numbers stay when metamers are shed.
inline constexpr std::string_view kMetamerColumn = "metamer";
/// Radians about the axis from its upper side to the lateral bud at a metamer's tip; in plants of metamers.
inline constexpr std::string_view kBudAngleColumn = "bud_angle";

/// The further column that counts the tips which each node has lost: what stood on them was shed or cut.
inline constexpr std::string_view kShedColumn = "shed";
/// The further column that marks, with 1, where a branch was said to end.
inline constexpr std::string_view kEndColumn = "end";

/// What a node that is set into the segment of `skeleton` from `begin` to `end`, `share` of the way, has in a further
/// column. Marks and counts of single nodes (`end`, `shed`) are 0 there; where a metamer has a number, all other
/// quantities are the metamer's as a whole; without a number they go evenly from node to node.
float inner_value(const Skeleton& skeleton, std::string_view column, NodeIndex begin, NodeIndex end, float share);

}  // namespace meristem
