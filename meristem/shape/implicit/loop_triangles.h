// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meristem/shape/implicit/cell_loops.h"

namespace meristem {

using CellTriangle = std::array<std::uint8_t, 3>;

/// Triangles and inner points, numbered as in CellSurface.
struct CellPieces {
  std::vector<CellTriangle> triangles;
  std::vector<std::uint16_t> inner;
};

void append(CellPieces& pieces, const CellPieces& more);

/// Returns a disc within the loop. No diagonal joins two points of one face of the cell, because the cell on the other
/// side could have the same diagonal. If no triangulation satisfies this, inner points are added.
CellPieces triangulate_loop(const CellLoop& loop, std::uint8_t pattern);

/// Returns the tunnel between two loops, with as many inner points as the shorter loop has points.
CellPieces triangulate_tunnel(const CellLoop& a, const CellLoop& b);

}  // namespace meristem
