// SPDX-License-Identifier: Apache-2.0
// Makes the surfaces of cells. For a pattern of corners, a way to join them on ambiguous faces, and a tunnel, the loops
// are traced and triangulated. The choice among the surfaces of a pattern is made elsewhere, from the cell's values.
// Tried first: making all surfaces at once, which took 8 ms, as long as the whole mesh of a small body.
#include "meristem/shape/implicit/cell_table.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "meristem/shape/implicit/cell_geometry.h"
#include "meristem/shape/implicit/cell_loops.h"

namespace meristem {
namespace {

constexpr int kTunnels = 3;

/// Returns an edge of the piece of surface that leaves the cell between two columns, at the height of a tunnel. There,
/// the first column is inside and the second outside.
std::optional<int> edge_between_columns(std::uint8_t pattern, int inside, int outside) {
  const auto is_inside = [&](int corner) { return (pattern >> corner & 1) != 0; };
  for (const int top : {0, 4}) {
    if (is_inside(inside | top) && !is_inside(outside | top)) return edge_between(inside | top, outside | top);
  }
  if (is_inside(inside) != is_inside(inside | 4)) return edge_between(inside, inside | 4);
  return std::nullopt;
}

/// Returns the two loops that the tunnel joins, if these signs allow a tunnel.
std::optional<std::pair<std::size_t, std::size_t>> joined_loops(const std::vector<CellLoop>& loops,
                                                                std::uint8_t pattern, Tunnel tunnel) {
  if (tunnel == Tunnel::none) return std::nullopt;
  std::vector<std::size_t> joined;
  const int parity = tunnel == Tunnel::between_odd_columns ? 1 : 0;
  for (const int inside : {parity, 3 - parity}) {
    for (const int outside : {inside ^ 1, inside ^ 2}) {
      const auto edge = edge_between_columns(pattern, inside, outside);
      if (!edge) return std::nullopt;
      const auto loop = std::find_if(loops.begin(), loops.end(), [&](const CellLoop& candidate) {
        return std::find(candidate.begin(), candidate.end(), *edge) != candidate.end();
      });
      joined.push_back(static_cast<std::size_t>(loop - loops.begin()));
    }
  }
  std::sort(joined.begin(), joined.end());
  joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
  if (joined.size() != 2) return std::nullopt;
  return std::pair(joined[0], joined[1]);
}

CellPieces make_pieces(const std::vector<CellLoop>& loops, std::uint8_t pattern,
                       std::optional<std::pair<std::size_t, std::size_t>> pair) {
  CellPieces pieces;
  if (pair) append(pieces, triangulate_tunnel(loops[pair->first], loops[pair->second]));
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (pair && (k == pair->first || k == pair->second)) continue;
    append(pieces, triangulate_loop(loops[k], pattern));
  }
  return pieces;
}

/// Returns the index of a subset among all subsets of a set of bits.
unsigned subset_index(std::uint8_t bits, std::uint8_t chosen) {
  unsigned index = 0, place = 1;
  for (unsigned bit = 0; bit < 8; ++bit) {
    if ((bits >> bit & 1) == 0) continue;
    if ((chosen >> bit & 1) != 0) index |= place;
    place <<= 1;
  }
  return index;
}

}  // namespace

CellTable::CellTable() {
  std::size_t count = 0;
  for (unsigned p = 0; p < 256; ++p) {
    const auto pattern = static_cast<std::uint8_t>(p);
    first_[p] = static_cast<std::uint16_t>(count);
    edges_[p] = find_crossed_edges(pattern);
    faces_[p] = find_ambiguous_faces(pattern);
    const bool one_surface = faces_[p] == 0 && cell_loops(pattern, 0).size() < 2;
    count += one_surface ? 1 : kTunnels << std::popcount(faces_[p]);
  }
  first_[256] = static_cast<std::uint16_t>(count);
  surfaces_ = std::vector<std::atomic<const CellSurface*>>(count);
}

const CellTable& CellTable::instance() {
  static const CellTable table;
  return table;
}

const CellSurface& CellTable::surface(std::uint8_t pattern, std::uint8_t joined, Tunnel tunnel) const {
  if (!is_ambiguous(pattern)) return surface(pattern);
  const std::size_t index =
      first_[pattern] + kTunnels * subset_index(faces_[pattern], joined) + static_cast<unsigned>(tunnel);
  const CellSurface* const made = surfaces_[index].load(std::memory_order_acquire);
  return made != nullptr ? *made : make(index, pattern, joined, tunnel);
}

const CellSurface& CellTable::make(std::size_t index, std::uint8_t pattern, std::uint8_t joined, Tunnel tunnel) const {
  const std::vector<CellLoop> loops = cell_loops(pattern, joined);
  const std::lock_guard lock(making_);
  // Another thread may have made the surface in the meantime.
  if (const CellSurface* const made = surfaces_[index].load(std::memory_order_relaxed)) return *made;
  Made& made = made_.emplace_back();
  made.pieces = make_pieces(loops, pattern, joined_loops(loops, pattern, tunnel));
  made.surface = {.triangles = made.pieces.triangles, .inner = made.pieces.inner};
  surfaces_[index].store(&made.surface, std::memory_order_release);
  return made.surface;
}

}  // namespace meristem
