// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace meristem {

// The loops of a surface on the faces of a cell. In a pattern, bit c is set if corner c of the cell is inside.

/// Returns the edges between an inside and an outside corner, one bit per edge.
std::uint16_t find_crossed_edges(std::uint8_t pattern);

/// Returns the faces (numbered as in cell_geometry.h) whose two inside corners are opposite, one bit per face.
std::uint8_t find_ambiguous_faces(std::uint8_t pattern);

/// The edges that a loop of the surface crosses, in order. Seen from outside the cell, inside corners lie on the left
/// of the loop, so that the surface within the loop faces outward.
using CellLoop = std::vector<std::uint8_t>;

/// Returns the loops in which the surface meets the cell's faces. The loop with the lowest edge comes first, and each
/// loop begins at its lowest edge. `joined` has the bits of the ambiguous faces on which the two inside corners are
/// joined.
std::vector<CellLoop> cell_loops(std::uint8_t pattern, std::uint8_t joined);

}  // namespace meristem
