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
  /// The share of the triangles of the level before that each level has, about; above 0 and below 1. From twice as far
  /// a plant covers a quarter of the pixels, so with a share of a quarter each level has about as many triangles per
  /// pixel as the level before at half the distance.
  double share = 0.25;

  /// The share of the triangles of level 0 that a level has, about.
  double kept(int of_level) const;
  double kept() const { return kept(level); }
};

/// Throws std::invalid_argument for a level or a share out of range.
void check_detail(const Detail& detail);

}  // namespace meristem
