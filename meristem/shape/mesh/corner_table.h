// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/progress.h"

namespace meristem {

/// The neighbours in a mesh while its edges collapse. Corner 3t + k is the k-th vertex of triangle t. Each corner
/// stores the corner on the other side of its opposite edge. The table has two whole numbers per corner and one per
/// vertex, and no lists.
///
/// Based on: J. Rossignac, A. Safonova, A. Szymczak: 3D Compression Made Simple: Edgebreaker on a Corner-Table (2001).
class CornerTable {
 public:
  using Corner = std::uint32_t;
  static constexpr Corner kNone = 0xFFFFFFFF;

  /// Builds the table in linear time. Vertices must be below `vertices`. Throws Cancelled.
  CornerTable(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertices, const Progress& progress);

  static Corner next(Corner c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static Corner previous(Corner c) { return c % 3 == 0 ? c + 2 : c - 1; }

  std::size_t corner_count() const { return sides_.size(); }
  std::size_t vertex_count() const { return first_.size(); }
  /// Returns the number of remaining triangles.
  std::size_t triangle_count() const { return triangles_; }

  std::uint32_t vertex(Corner c) const { return sides_[c].vertex; }
  /// Returns the corner beyond the edge from next(c) to previous(c), or kNone at a border.
  Corner opposite(Corner c) const { return sides_[c].opposite; }
  /// Returns some corner of a vertex, or kNone if it has none (left).
  Corner corner_of(std::uint32_t vertex) const { return first_[vertex]; }
  /// Returns the corner of the same vertex in the triangle beyond the edge to previous(c), which is the next one
  /// counter-clockwise.
  Corner turn(Corner c) const {
    const Corner beyond = sides_[next(c)].opposite;
    return beyond == kNone ? kNone : next(beyond);
  }
  /// Returns false for vertices on borders, on edges of more than two triangles, on edges of two triangles with
  /// opposite orientation, and for vertices whose triangles form several fans. Only around other vertices can turn() be
  /// repeated.
  bool is_inner(std::uint32_t vertex) const { return inner_[vertex] != 0; }

  /// Removes the two triangles at the edge from the vertex of `c` to the vertex of next(c). The other triangles of the
  /// second vertex become triangles of the vertex of `c`. Both vertices must be inner, and must have exactly two common
  /// neighbours.
  void collapse(Corner c);

 private:
  void pair_corners(const Progress& progress);
  void find_inner(const Progress& progress);
  void remove_triangle(Corner kept, Corner gone);

  // Stored together, because both are usually read together.
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
