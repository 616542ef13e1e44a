// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "meristem/graph/graph.h"
#include "meristem/graph/table/site.h"

namespace meristem {

/// Depths of an instance in each level of nested recursions, as in Site::depths.
using RecursionDepths = std::array<std::uint16_t, kMaxRecursionLevels>;

/// Returns true if instances at these depths have children by the link. A link back makes children until its depth is
/// reached, and a leaf link only from that depth on.
bool leads_on(const Graph& graph, LinkIndex link, const RecursionDepths& depths);

/// Changes the depths of a parent to the depths of its children by the link. A recursion that is entered anew starts at
/// depth 0, and so does each recursion within it.
void count_depth(const LinkStructure& structure, LinkIndex link, ComponentIndex to, RecursionDepths& depths);

}  // namespace meristem
