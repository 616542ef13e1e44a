// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Column with the number of each metamer on its axis, from 1 at the base; roots have 0. All nodes of one metamer have
/// its number. Numbers do not change when metamers are shed.
inline constexpr std::string_view kMetamerColumn = "metamer";
/// Column with the angle, in radians about the axis, from the axis's upper side to the lateral bud at a metamer's tip.
/// Exists in plants of metamers only.
inline constexpr std::string_view kBudAngleColumn = "bud_angle";

/// Column with the number of tips that each node has lost by shedding or cutting.
inline constexpr std::string_view kShedColumn = "shed";
/// Column with 1 at nodes that the author marked as the end of a branch.
inline constexpr std::string_view kEndColumn = "end";

/// Returns the value of a column for a new node in the segment of `skeleton` from `begin` to `end`, at the fraction
/// `share` of the segment. Marks and counts of single nodes (`end`, `shed`) are 0. If the segment belongs to a metamer,
/// all other quantities have the metamer's value. Otherwise they are interpolated linearly.
float inner_value(const Skeleton& skeleton, std::string_view column, NodeIndex begin, NodeIndex end, float share);

}  // namespace meristem
