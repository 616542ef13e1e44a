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

/// Selects the features of an MTG that hold positions and diameters, and their units, because files do not name their
/// units.
struct MtgGeometry {
  std::array<std::string, 3> position{"XX", "YY",
                                      "ZZ"};  ///< features of an entity's end: toward east, toward north, up
  std::string diameter;      ///< feature of an entity's end; empty: TopDia or TopDiameter if present, else no radii
  std::optional<int> scale;  ///< scale of the entities that become nodes; unset: the finest
  double length_unit = 1;    ///< metres that a coordinate of 1 means
  double diameter_unit = 1;  ///< metres that a diameter of 1 means
};

/// A skeleton and the entity of each node.
struct MtgSkeleton {
  Skeleton skeleton;              ///< parents before children
  std::vector<MtgVertex> vertex;  ///< entity of each node
  std::uint64_t guessed = 0;      ///< number of nodes without coordinates, placed at their parents
};

/// Returns the entities of one scale as a skeleton. Each entity is a segment from its parent's end to its own end. A
/// root entity's segment begins at the coordinates of the axis or plant that it begins, if these have coordinates.
/// Otherwise its end is a single root node. An entity without coordinates, diameter or `birth` has its parent's. The
/// first successor continues an axis; all other children begin a lateral axis of the next order. Coordinates are
/// rotated to y up and north -z. Segments may have zero length, and radii may rise toward the tips, as they were
/// digitised.
///
/// Numeric features that some node has become further columns, with NaN for nodes without a value. Features with
/// reserved names of columns, or of what `write_skeleton_mtg` writes for every skeleton, do not become columns. Without
/// a feature `metamer`, the entities' own numbers become the metamer numbers if they count every axis from 1. A feature
/// `node` that numbers all nodes, each once and parents first, defines the order of the nodes. Features `axis` and
/// `order` then also apply if they are consistent. So the output of `write_skeleton_mtg` is read back unchanged.
///
/// Throws InputError, with the line in `file`, for a scale without entities, missing features and roots without
/// coordinates. Throws it also for coordinates beyond 1000 km, negative diameters, and more than 16 numbers for each
/// node that `limits` allow. Throws std::invalid_argument for units that are not positive. Cost: linear, plus sorting
/// the nodes.
MtgSkeleton skeleton_of(const MtgTree& tree, const std::string& file, const MtgGeometry& geometry,
                        const SizeLimits& limits);

}  // namespace meristem
