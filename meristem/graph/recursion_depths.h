// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "meristem/graph/graph.h"
#include "meristem/graph/table/site.h"

namespace meristem {

/// How deep an instance is in each level of nested recursions, as in Site::depths.
using RecursionDepths = std::array<std::uint16_t, kMaxRecursionLevels>;

/// Returns true if instances at these depths have children by the link: a link back leads on until its depth is
/// reached, a leaf link only from there.
bool leads_on(const Graph& graph, LinkIndex link, const RecursionDepths& depths);

/// Changes the depths of a parent to those of its children by the link. A recursion entered from outside, or within one
/// that begins anew, starts at 0.
void count_depth(const Structure& structure, LinkIndex link, ComponentIndex to, RecursionDepths& depths);

}  // namespace meristem
