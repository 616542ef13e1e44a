// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "meristem/grow/prune/operation.h"
#include "meristem/grow/prune/tree_state.h"

namespace meristem {

/// A lateral bud of the leader that will be an arm, or is one, and the number of the wire that it follows.
struct ArmBud {
  MetamerIndex metamer = 0;
  std::size_t wire = 0;
};

/// All of a tree, from the ground up.
std::vector<ArmBud> find_arms(const Metamers& metamers, const Leads& leads, const Layers& what);

/// The wires of the arms, two to a layer from the ground up, the left one first. `length` is that of a metamer.
std::vector<std::vector<Vec3>> arm_wires(const Layers& what, double length);

}  // namespace meristem
