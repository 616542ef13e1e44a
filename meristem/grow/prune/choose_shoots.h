// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/grow/prune/operation.h"
#include "meristem/grow/prune/tree_state.h"

namespace meristem {

/// The shoots that an operation is for, by rising axes. A label means the shoot of that name alone; the leader and
/// those that a condition finds are whole leads, with all that has succeeded them. Throws InputError at the document
/// path of `shoots`, with the names that there are, for a label without a shoot.
std::vector<Shoot> choose_shoots(const TreeState& tree, const Operation& operation);

/// Whether the condition of a schedule holds.
bool holds(const TreeState& tree, const Schedule& when);

}  // namespace meristem
