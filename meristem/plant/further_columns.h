// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// The further column in which a growth model numbers its metamers: those of an axis from 1 at its base, 0 at a root.
/// All nodes of one metamer have its number. Numbers stay when others are shed.
inline constexpr std::string_view kMetamerColumn = "metamer";

/// What a node that is set into a segment of `skeleton` has in a further column: `begin` and `end` are the values at
/// the segment's ends, `share` of the way from one to the other. Marks and counts of single nodes (`end`, `shed`) are 0
/// there; where metamers are numbered, all else is said of the metamer that the segment ends with; other quantities go
/// evenly from node to node.
float inner_value(const Skeleton& skeleton, std::string_view column, float begin, float end, float share);

}  // namespace meristem
