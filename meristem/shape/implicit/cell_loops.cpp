// SPDX-License-Identifier: Apache-2.0
// Traces the loops of a cell's surface. On each face, the boundary between inside and outside connects two crossed
// edges, or four on an ambiguous face. Following these connections from edge to edge closes each loop.
#include "meristem/shape/implicit/cell_loops.h"

#include "meristem/shape/implicit/cell_geometry.h"

namespace meristem {
namespace {

bool is_inside(std::uint8_t pattern, int corner) { return (pattern >> corner & 1) != 0; }

/// The positions where a walk around a face, counter-clockwise, enters the inside and leaves it: one or two visits.
struct Visits {
  int count = 0;
  std::array<int, 2> entries{}, exits{};
};

Visits visits_of(std::uint8_t pattern, int face) {
  const std::array<int, 4> corners = face_corners(face);
  Visits visits;
  for (int k = 0; k < 4; ++k) {
    if (is_inside(pattern, corners[k]) || !is_inside(pattern, corners[(k + 1) % 4])) continue;
    int last = (k + 1) % 4;
    while (is_inside(pattern, corners[(last + 1) % 4])) last = (last + 1) % 4;
    visits.entries[visits.count] = edge_between(corners[k], corners[(k + 1) % 4]);
    visits.exits[visits.count] = edge_between(corners[last], corners[(last + 1) % 4]);
    ++visits.count;
  }
  return visits;
}

}  // namespace

std::uint16_t find_crossed_edges(std::uint8_t pattern) {
  std::uint16_t edges = 0;
  for (int edge = 0; edge < kCellEdges; ++edge) {
    const auto [low, high] = edge_corners(edge);
    if (is_inside(pattern, low) != is_inside(pattern, high)) edges |= static_cast<std::uint16_t>(1 << edge);
  }
  return edges;
}

std::uint8_t find_ambiguous_faces(std::uint8_t pattern) {
  std::uint8_t faces = 0;
  for (int face = 0; face < kCellFaces; ++face) {
    if (visits_of(pattern, face).count == 2) faces |= static_cast<std::uint8_t>(1 << face);
  }
  return faces;
}

std::vector<CellLoop> cell_loops(std::uint8_t pattern, std::uint8_t joined) {
  // On each face, the surface connects the edge where the walk enters with the edge where it leaves. If inside corners
  // are joined, it connects across the neck.
  std::array<int, kCellEdges> next;
  next.fill(-1);
  for (int face = 0; face < kCellFaces; ++face) {
    const Visits visits = visits_of(pattern, face);
    const int other = visits.count == 2 && (joined >> face & 1) != 0 ? 1 : 0;
    for (int k = 0; k < visits.count; ++k) next[visits.entries[k]] = visits.exits[k ^ other];
  }

  // Each crossed edge is entered on one of its faces and left on the other, so the connections form loops.
  std::vector<CellLoop> loops;
  std::uint16_t left = find_crossed_edges(pattern);
  for (int edge = 0; edge < kCellEdges; ++edge) {
    if ((left >> edge & 1) == 0) continue;
    CellLoop loop;
    for (int at = edge; (left >> at & 1) != 0; at = next[at]) {
      left &= static_cast<std::uint16_t>(~(1 << at));
      loop.push_back(static_cast<std::uint8_t>(at));
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace meristem
