// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace meristem {

/// The last level of detail.
inline constexpr int kCoarsestDetail = 8;

/// The most upright cards that may stand for a plant, crossed pictures of it, after its last level.
inline constexpr int kMostCards = 16;

/// How coarse the meshes of a plant are.
struct Detail {
  int level = 0;  ///< 0: all there is; raised, fewer triangles; at most kCoarsestDetail
  /// Of the triangles of the level before, that each level has, about; above 0 and below 1. From twice as far a plant
  /// covers a quarter of the pixels: with a quarter each level has about as many triangles per pixel, and suits twice
  /// the distance of the one before.
  double share = 0.25;

  /// Of the triangles of level 0, that a level has, about.
  double kept(int of_level) const;
  double kept() const { return kept(level); }
};

/// Throws std::invalid_argument for a level or a share out of range.
void check_detail(const Detail& detail);

}  // namespace meristem
