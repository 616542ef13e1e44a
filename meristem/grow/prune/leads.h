// SPDX-License-Identifier: Apache-2.0
// Who leads. Where the terminal bud of a shoot is cut, the shoot at the cut metamer leads on, or the next one below it;
// while its bud sleeps, no shoot leads. A shoot with those that succeed it is a lead. Ranks count leads and not axes: 0
// the leader of the tree, 1 the arms and branches on it, 2 what stands on these.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/grow/metamer/metamers.h"

namespace meristem {

struct Leads {
  std::vector<std::uint16_t> rank;    ///< rank of each axis
  std::vector<AxisIndex> heir;        ///< the axis that leads on from each, or kNoAxis
  std::vector<MetamerIndex> from;     ///< the metamer whose lateral bud or shoot leads each axis on, or kNoNode
  std::vector<std::uint8_t> is_heir;  ///< whether an axis leads another one on
  AxisIndex leader = kNoAxis;         ///< the axis that leads the tree; kNoAxis while none does

  /// The rank of what the bud of a metamer grows.
  std::uint16_t rank_of_bud(const Metamers& metamers, MetamerIndex metamer, bool is_lateral) const {
    const AxisIndex axis = metamers.axis[metamer];
    return static_cast<std::uint16_t>(rank[axis] + (is_lateral && from[axis] != metamer ? 1 : 0));
  }
};

/// Cost is linear.
Leads find_leads(const Metamers& metamers);

/// The last axis of the lead that begins with `head`.
inline AxisIndex lead_end(const Leads& leads, AxisIndex head) {
  while (leads.heir[head] != kNoAxis) head = leads.heir[head];
  return head;
}

/// The metamers of a lead from its base to its tip, without the seed. `head` is the axis that it begins with.
std::vector<MetamerIndex> lead_path(const Metamers& metamers, const Leads& leads, AxisIndex head);

}  // namespace meristem
