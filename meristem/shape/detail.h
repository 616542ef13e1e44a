// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

namespace meristem {

/// The last level of detail.
inline constexpr int kCoarsestDetail = 8;

/// The most upright cards that may stand for a plant, crossed pictures of it, after its last level.
inline constexpr int kMostCards = 16;

/// Counts the geometry that was worked on while meshing, whether or not it is part of the result. Any thread may count.
struct MeshWork {
  /// Triangles of tubes and bodies that were made, and of organ meshes that were read to make them coarser.
  std::atomic<std::uint64_t> triangles{0};
  std::atomic<std::uint64_t> plants{
      0};  ///< plants whose meshes were made; a plant that stands in many places counts once
};

/// How coarse the meshes of a plant are.
struct Detail {
  int level = 0;  ///< 0: all there is; raised, fewer triangles; at most kCoarsestDetail
  /// The share of the triangles of the level before that each level has, about; above 0 and below 1. From twice as far
  /// a plant covers a quarter of the pixels, so with a share of a quarter each level has about as many triangles per
  /// pixel as the level before at half the distance.
  double share = 0.25;
  /// If true, a level above 0 is made in time that grows with its own triangles, for views that change: rougher than a
  /// level of a file, and without the search for outlines of small plants.
  bool is_quick = false;
  MeshWork* work = nullptr;  ///< counts what is made; null: nobody counts

  /// The share of the triangles of level 0 that a level has, about.
  double kept(int of_level) const;
  double kept() const { return kept(level); }
};

/// Throws std::invalid_argument for a level or a share out of range.
void check_detail(const Detail& detail);

}  // namespace meristem
