// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/progress.h"

namespace meristem {

/// Who is whose neighbour in a mesh, while its edges collapse. Corner 3t + k is triangle t at its k-th vertex; each
/// knows the corner that looks at it across the edge opposite. Two whole numbers per corner and one per vertex, no
/// lists.
///
/// Based on: J. Rossignac, A. Safonova, A. Szymczak: 3D Compression Made Simple: Edgebreaker on a Corner-Table (2001).
class CornerTable {
 public:
  using Corner = std::uint32_t;
  static constexpr Corner kNone = 0xFFFFFFFF;

  /// Linear. Vertices must be below `vertices`. Throws Cancelled.
  CornerTable(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertices, const Progress& progress);

  static Corner next(Corner c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static Corner previous(Corner c) { return c % 3 == 0 ? c + 2 : c - 1; }

  std::size_t corner_count() const { return sides_.size(); }
  std::size_t vertex_count() const { return first_.size(); }
  /// Triangles that are left.
  std::size_t triangle_count() const { return triangles_; }

  std::uint32_t vertex(Corner c) const { return sides_[c].vertex; }
  /// The corner beyond the edge from next(c) to previous(c); kNone at a border.
  Corner opposite(Corner c) const { return sides_[c].opposite; }
  /// Some corner of a vertex; kNone if it has none (any more).
  Corner corner_of(std::uint32_t vertex) const { return first_[vertex]; }
  /// The corner of the same vertex in the triangle beyond the edge to previous(c), which is counter-clockwise.
  Corner turn(Corner c) const {
    const Corner beyond = sides_[next(c)].opposite;
    return beyond == kNone ? kNone : next(beyond);
  }
  /// False for vertices on borders, on edges of more than two triangles or of two that are turned against each other,
  /// and for those whose triangles are several fans. Only around the others can one turn.
  bool is_inner(std::uint32_t vertex) const { return inner_[vertex] != 0; }

  /// Takes out the two triangles at the edge from the vertex of `c` to the vertex of next(c), whose other triangles
  /// become those of the vertex of `c`. Both vertices are inner and have, beside each other, two neighbours in common.
  void collapse(Corner c);

 private:
  void pair_corners(const Progress& progress);
  void find_inner(const Progress& progress);
  void remove_triangle(Corner kept, Corner gone);

  // Together, as whoever asks for one asks for the other.
  struct Side {
    std::uint32_t vertex;
    Corner opposite;
  };

  std::vector<Side> sides_;
  std::vector<Corner> first_;
  std::vector<std::uint8_t> inner_;
  std::size_t triangles_ = 0;
};

}  // namespace meristem
