// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

namespace meristem {

/// The last level of detail.
inline constexpr int kCoarsestDetail = 8;

/// Maximum number of upright cards (crossed pictures of a plant) that can replace a plant after its last level.
inline constexpr int kMaxCards = 16;

/// Counts the geometry that meshing has processed, whether or not it is part of the result. Any thread may count.
struct MeshWork {
  /// Triangles of tubes and bodies that were made, and of organ meshes that were read to coarsen them.
  std::atomic<std::uint64_t> triangles{0};
  std::atomic<std::uint64_t> plants{
      0};  ///< number of plants whose meshes were made; a plant in many places counts once
};

/// The coarseness of a plant's meshes.
struct MeshDetail {
  int level = 0;  ///< 0: full detail; larger levels have fewer triangles; at most kCoarsestDetail
  /// Number of triangles of each level, as a share of the level before, approximately. Must be above 0 and below 1. At
  /// twice the distance, a plant covers a quarter of the pixels. With a share of 0.25, each level therefore has about
  /// as many triangles per pixel as the level before at half the distance.
  double share = 0.25;
  /// If true, a level above 0 is made in time that grows with its own triangles, for views that change. The result is
  /// rougher than a level of a file, and outlines of small plants are not searched.
  bool is_quick = false;
  MeshWork* work = nullptr;  ///< counts the processed geometry; may be null

  /// Returns about the share of the triangles of level 0 that a level has.
  double kept(int of_level) const;
  double kept() const { return kept(level); }
};

/// Throws std::invalid_argument for a level or a share out of range.
void check_detail(const MeshDetail& detail);

}  // namespace meristem
