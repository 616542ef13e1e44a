// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meristem/shape/implicit/cell_loops.h"

namespace meristem {

using CellTriangle = std::array<std::uint8_t, 3>;

/// Triangles and inner points as in CellSurface.
struct CellPieces {
  std::vector<CellTriangle> triangles;
  std::vector<std::uint16_t> inner;
};

void append(CellPieces& pieces, const CellPieces& more);

/// A disc within the loop. No diagonal joins two points of one face of the cell, as the cell on the other side might
/// have it too; where that leaves no triangles there are inner points.
CellPieces triangulate_loop(const CellLoop& loop, std::uint8_t pattern);

/// The tunnel between two loops, with as many inner points as the shorter has points.
CellPieces triangulate_tunnel(const CellLoop& a, const CellLoop& b);

}  // namespace meristem
