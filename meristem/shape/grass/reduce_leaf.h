// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/shape/grass/grass_leaf.h"

namespace meristem {

/// The order in which the inner points of a leaf can be removed, with the cost of each step. One order gives all levels
/// of detail, so the points of a coarser level are a subset of the points of a finer one.
struct ReductionOrder {
  std::vector<std::uint32_t> points;  ///< first removed point first; all points except both ends
  std::vector<double> errors;         ///< largest error up to this step, as a share of the length or width
};

/// Computes the order. The inner point nearest to the chord between its present neighbours is removed first. Its error
/// is sqrt(e_xy^2 + e_r^2), from the distances of (x, y) and of (s, r) to their chords. `also` are further functions of
/// s that count alike, as shares of the length with one number per point (for example the edge's height of a twisted
/// blade). Ties go to the lower index. Throws std::invalid_argument for lists of other lengths, fewer than 2 points,
/// and numbers that are not finite. The cost is n log n. Based on: Fournier and Pradal (2012), section 2.6.
ReductionOrder reduction_order(const GrassLeaf& leaf, const std::vector<std::vector<double>>& also = {});

/// Returns the points that remain if `pieces` pieces (at least 1) are wanted: ascending indices, both ends included.
std::vector<std::uint32_t> points_kept(const ReductionOrder& order, std::size_t pieces);
/// Returns the points that remain if no step may cost more than `error`: ascending indices, both ends included.
std::vector<std::uint32_t> points_within(const ReductionOrder& order, double error);

/// Returns the leaf with only these points, widened so that its area stays.
GrassLeaf reduced(const GrassLeaf& leaf, const std::vector<std::uint32_t>& points);

}  // namespace meristem
