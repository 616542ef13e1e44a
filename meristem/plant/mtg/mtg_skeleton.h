// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "meristem/plant/mtg/mtg.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Which features of an MTG say where its entities are and how thick. Files do not name their units.
struct MtgGeometry {
  std::array<std::string, 3> position{"XX", "YY",
                                      "ZZ"};  ///< features of an entity's end: to the east, to the north, up
  std::string diameter;  ///< feature of an entity's end; empty: TopDia or TopDiameter if there is one, else no radii
  std::optional<int> scale;  ///< scale of the entities that become nodes; unset: the finest
  double length_unit = 1;    ///< metres that a coordinate of 1 means
  double diameter_unit = 1;  ///< metres that a diameter of 1 means
};

/// A skeleton and what its nodes are in the MTG.
struct MtgSkeleton {
  Skeleton skeleton;
  std::vector<MtgVertex> vertex;  ///< entity of each node
  std::uint64_t guessed = 0;      ///< nodes without coordinates, which stand at their parents
};

/// The entities of one scale as a skeleton: each is a segment from its parent's end to its own. Where the axis
/// or plant that an entity begins has coordinates of its own, these are where the root's segment begins; else the
/// root's end is a node alone. An entity without coordinates, diameter or `birth` has its parent's. The first successor
/// continues an axis, all else begins a lateral one of the next order. Coordinates turn to y up and north -z.
/// Segments may have no length, and radii may rise toward the tips, as they were digitised.
///
/// Features that are numbers and that nodes have become further columns, NaN where a node has none. Features with the
/// names of other columns and of what `write_skeleton_mtg` writes for every skeleton become none. Where no feature is
/// the `metamer`, and the entities' own numbers count every axis from 1, these do. Where a feature `node` numbers the
/// nodes, each once and parents first, they have that order and, beside it, what features `axis` and `order` say, if
/// they can: so what `write_skeleton_mtg` has written comes back as it was.
///
/// Throws InputError, with the line in `file`, for a scale without entities, for features that are not there, roots
/// without coordinates, coordinates beyond 1000 km and negative diameters, and for more than 16 numbers for each node
/// that `limits` allow; std::invalid_argument for units that are not positive. Cost linear, but for the sorting of
/// nodes.
MtgSkeleton skeleton_of(const MtgTree& tree, const std::string& file, const MtgGeometry& geometry,
                        const Limits& limits);

}  // namespace meristem
