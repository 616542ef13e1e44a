// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <mutex>
#include <vector>

#include "meristem/shape/implicit/cell_surface.h"
#include "meristem/shape/implicit/loop_triangles.h"

namespace meristem {

/// The connection inside a cell between four columns (the edges along z), if opposite columns have equal signs and
/// neighbours do not.
enum class Tunnel : std::uint8_t {
  none,
  between_even_columns,  ///< the columns with x = y are inside
  between_odd_columns,   ///< the columns with x != y are inside
};

/// Every surface that a cell can have. Each surface is made when a cell needs it for the first time, because a body has
/// few of the 1,712.
class CellTable {
 public:
  /// Returns the only table.
  static const CellTable& instance();

  /// `joined` must have only bits of ambiguous faces, on which the two inside corners are joined.
  const CellSurface& surface(std::uint8_t pattern, std::uint8_t joined, Tunnel tunnel) const;
  /// Returns the surface of a pattern that is not ambiguous.
  const CellSurface& surface(std::uint8_t pattern) const {
    const CellSurface* const made = surfaces_[first_[pattern]].load(std::memory_order_acquire);
    return made != nullptr ? *made : make(first_[pattern], pattern, 0, Tunnel::none);
  }
  /// Returns true if these signs have more than one surface.
  bool is_ambiguous(std::uint8_t pattern) const { return first_[pattern + 1] > first_[pattern] + 1; }
  std::uint8_t ambiguous_faces(std::uint8_t pattern) const { return faces_[pattern]; }
  std::uint16_t crossed_edges(std::uint8_t pattern) const { return edges_[pattern]; }

  CellTable(const CellTable&) = delete;
  CellTable& operator=(const CellTable&) = delete;

 private:
  struct Made {
    CellPieces pieces;
    CellSurface surface;  ///< its spans refer to the pieces
  };

  CellTable();
  const CellSurface& make(std::size_t index, std::uint8_t pattern, std::uint8_t joined, Tunnel tunnel) const;

  std::array<std::uint16_t, 257> first_{};  ///< first surface of each pattern, which has one surface, or one for each
                                            ///< way to join and tunnel
  std::array<std::uint8_t, 256> faces_{};
  std::array<std::uint16_t, 256> edges_{};
  mutable std::vector<std::atomic<const CellSurface*>> surfaces_;  ///< null until made
  mutable std::mutex making_;
  mutable std::deque<Made> made_;
};

}  // namespace meristem
