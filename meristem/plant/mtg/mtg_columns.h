// SPDX-License-Identifier: Apache-2.0
// Columns of a skeleton other than positions in an MTG file, for the reader and the writer.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/plant/mtg/mtg_skeleton.h"

namespace meristem {

/// Returns true if a further column of a skeleton may use this name in a file. Columns that are written for every
/// skeleton have reserved names, and some texts are invalid names of features.
bool is_mtg_column_name(std::string_view name);

/// Returns true if programs that read MTG split words at this sign.
inline bool is_mtg_sign(char c) {
  return std::string_view("+<>/\\[](){},=:;*^#\"' ").find(c) != std::string_view::npos;
}

/// Sets the remaining columns of a skeleton whose positions, axes and orders are known: births, further columns,
/// metamer numbers, and the order of nodes. `node_of` is the node of each vertex, or kNoNode. `geometry` lists the
/// features that do not become further columns. Throws InputError if there are more than 16 numbers for each node that
/// `limits` allow.
void read_mtg_columns(const MtgTree& tree, const std::string& file, std::span<const NodeIndex> node_of,
                      std::span<const std::string> geometry, const SizeLimits& limits, MtgSkeleton& made);

}  // namespace meristem
