// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/grow/prune/operation.h"
#include "meristem/grow/prune/tree_state.h"

namespace meristem {

/// Returns the shoots of an operation, sorted by axis. A label selects only the shoot with that name. The leader and
/// shoots of a condition are complete leads, including their successors. Throws InputError at the document path of
/// `shoots`, with existing names, for a label without a shoot.
std::vector<Shoot> choose_shoots(const TreeState& tree, const TreeOperation& operation);

/// Returns true if the condition of a schedule holds.
bool holds(const TreeState& tree, const OperationSchedule& when);

}  // namespace meristem
