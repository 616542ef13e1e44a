// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace meristem {

// A pattern has bit c where corner c of a cell is inside.

/// The edges between an inside and an outside corner, one bit per edge.
std::uint16_t find_crossed_edges(std::uint8_t pattern);

/// The faces (numbered as in cell_geometry.h) whose two inside corners lie across, one bit per face.
std::uint8_t find_ambiguous_faces(std::uint8_t pattern);

/// The edges that a loop of the surface crosses, in order: inside corners lie on its left, seen from outside of the
/// cell along its faces, so that the piece within it faces outward.
using CellLoop = std::vector<std::uint8_t>;

/// The loops in which the surface meets the cell's faces, that with the lowest edge first and each from its lowest
/// edge. `joined` has the bits of those ambiguous faces on which the two inside corners are joined.
std::vector<CellLoop> cell_loops(std::uint8_t pattern, std::uint8_t joined);

}  // namespace meristem
