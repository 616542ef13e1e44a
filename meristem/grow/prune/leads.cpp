// SPDX-License-Identifier: Apache-2.0
// Finds successors and the leader first, then ranks in one pass over the axes. See leads.h.
#include "meristem/grow/prune/leads.h"

#include <algorithm>

namespace meristem {

namespace {

/// Searches down an axis from `top` for the lateral that continues it, and stores it in `leads`. Returns true if one
/// was found.
bool find_heir(const Metamers& metamers, AxisIndex axis, MetamerIndex top, TreeLeads& leads) {
  leads.heir[axis] = kNoAxis;
  leads.from[axis] = kNoNode;
  for (MetamerIndex metamer = top;; metamer = metamers.parent[metamer]) {
    const Bud bud = metamers.lateral[metamer];
    if (bud.is_grown() || bud.is_open()) {
      leads.from[axis] = metamer;
      if (bud.is_grown()) leads.heir[axis] = metamers.axis[bud.metamer()];
      return true;
    }
    if (metamer == metamers.axes[axis].first) return false;
  }
}

bool needs_heir(const Metamers& metamers, AxisIndex axis) {
  const Metamers::Axis& own = metamers.axes[axis];
  return !own.has_no_heir && metamers.terminal[own.last].is_damaged();
}

/// Finds the leader of the tree. If a successor has no bud that could continue, the next lateral below it leads.
void find_leader(const Metamers& metamers, TreeLeads& leads) {
  AxisIndex axis = 0;
  while (needs_heir(metamers, axis)) {
    bool found = leads.from[axis] != kNoNode;
    while (!found && axis != 0) {
      const MetamerIndex bearer = metamers.parent[metamers.axes[axis].first];
      axis = metamers.axis[bearer];
      if (bearer == metamers.axes[axis].first) {
        leads.heir[axis] = kNoAxis;
        leads.from[axis] = kNoNode;
      } else {
        found = find_heir(metamers, axis, metamers.parent[bearer], leads);
      }
    }
    if (leads.heir[axis] == kNoAxis) return;  // its bud is dormant, or nothing is left
    axis = leads.heir[axis];
  }
  if (!metamers.axes[axis].has_no_heir) leads.leader = axis;
}

}  // namespace

TreeLeads find_leads(const Metamers& metamers) {
  const std::size_t count = metamers.axes.size();
  TreeLeads leads;
  leads.rank.assign(count, 0);
  leads.heir.assign(count, kNoAxis);
  leads.from.assign(count, kNoNode);
  leads.is_heir.assign(count, 0);
  for (AxisIndex axis = 0; axis < count; ++axis) {
    if (!metamers.axes[axis].is_loose && needs_heir(metamers, axis))
      find_heir(metamers, axis, metamers.axes[axis].last, leads);
  }
  find_leader(metamers, leads);
  for (AxisIndex axis = 0; axis < count; ++axis) {
    if (leads.heir[axis] != kNoAxis) leads.is_heir[leads.heir[axis]] = 1;
    if (axis == 0 || metamers.axes[axis].is_loose) continue;
    const AxisIndex bearer = metamers.axis[metamers.parent[metamers.axes[axis].first]];
    leads.rank[axis] = static_cast<std::uint16_t>(leads.rank[bearer] + (leads.heir[bearer] == axis ? 0 : 1));
  }
  return leads;
}

std::vector<MetamerIndex> lead_path(const Metamers& metamers, const TreeLeads& leads, AxisIndex head) {
  const AxisIndex end = lead_end(leads, head);
  // A lead whose heir is dormant, or belongs to a lower lead, ends at the end of its own axis.
  std::vector<MetamerIndex> path;
  const MetamerIndex first = metamers.axes[head].first;
  for (MetamerIndex metamer = metamers.axes[end].last; metamer != 0; metamer = metamers.parent[metamer]) {
    path.push_back(metamer);
    if (metamer == first) break;
  }
  std::ranges::reverse(path);
  return path;
}

}  // namespace meristem
