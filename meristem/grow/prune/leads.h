// SPDX-License-Identifier: Apache-2.0
// Succession of shoots. If the terminal bud of a shoot is cut, the lateral shoot at the cut metamer, or the next one
// below it, continues the shoot. While its bud is dormant, no shoot continues. A lead is a shoot with its successors.
// Ranks count leads instead of axes: 0 for the leader of the tree, 1 for arms and branches on it, 2 for shoots on
// these.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/grow/metamer/metamers.h"

namespace meristem {

/// The leads of a tree, by axis.
struct TreeLeads {
  std::vector<std::uint16_t> rank;    ///< rank of each axis
  std::vector<AxisIndex> heir;        ///< the axis that continues each axis, or kNoAxis
  std::vector<MetamerIndex> from;     ///< the metamer whose lateral bud or shoot continues each axis, or kNoNode
  std::vector<std::uint8_t> is_heir;  ///< 1 if the axis continues another axis
  AxisIndex leader = kNoAxis;         ///< the axis that leads the tree; kNoAxis while no axis leads

  /// Returns the rank of a shoot grown by the bud of a metamer.
  std::uint16_t rank_of_bud(const Metamers& metamers, MetamerIndex metamer, bool is_lateral) const {
    const AxisIndex axis = metamers.axis[metamer];
    return static_cast<std::uint16_t>(rank[axis] + (is_lateral && from[axis] != metamer ? 1 : 0));
  }
};

/// Cost: linear.
TreeLeads find_leads(const Metamers& metamers);

/// Returns the last axis of the lead that begins with `head`.
inline AxisIndex lead_end(const TreeLeads& leads, AxisIndex head) {
  while (leads.heir[head] != kNoAxis) head = leads.heir[head];
  return head;
}

/// Returns the metamers of a lead from base to tip, without the seed. `head` is the first axis of the lead.
std::vector<MetamerIndex> lead_path(const Metamers& metamers, const TreeLeads& leads, AxisIndex head);

}  // namespace meristem
