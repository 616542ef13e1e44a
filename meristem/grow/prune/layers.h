// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "meristem/grow/prune/operation.h"
#include "meristem/grow/prune/tree_state.h"

namespace meristem {

/// A lateral bud of the leader that is or will be an arm, and the number of its wire.
struct ArmBud {
  MetamerIndex metamer = 0;
  std::size_t wire = 0;
};

/// Returns all arms of a tree, from the ground up.
std::vector<ArmBud> find_arms(const Metamers& metamers, const TreeLeads& leads, const LayersOperation& what);

/// Returns the wires of the arms, two per layer from the ground up, left first. `length` is the length of a metamer.
std::vector<std::vector<Vec3>> arm_wires(const LayersOperation& what, double length);

}  // namespace meristem
