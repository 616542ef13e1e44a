// SPDX-License-Identifier: Apache-2.0
// What an MTG says of a skeleton's nodes beside their positions, for its reader and its writer.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/plant/mtg/mtg_skeleton.h"

namespace meristem {

/// Whether a further column of a skeleton goes by this name in a file: what is written and read for every skeleton has
/// its own names, and some texts are no names of features.
bool is_mtg_column_name(std::string_view name);

/// Whether programs that read MTG take words apart at a sign.
inline bool is_mtg_sign(char c) {
  return std::string_view("+<>/\\[](){},=:;*^#\"' ").find(c) != std::string_view::npos;
}

/// Gives a skeleton, whose positions, axes and orders are known, what else the entities of its nodes have: ages,
/// further columns, the numbers of metamers, and the order of its nodes. `node_of` has the node of each vertex or
/// kNoNode; `geometry` are the features that are no further columns. Throws InputError for more than 16 numbers for
/// each node of `limits`.
void read_mtg_columns(const MtgTree& tree, const std::string& file, std::span<const NodeIndex> node_of,
                      std::span<const std::string> geometry, const Limits& limits, MtgSkeleton& made);

}  // namespace meristem
