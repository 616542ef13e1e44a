// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/shape/grass/grass_leaf.h"

namespace meristem {

/// The order in which the inner points of a leaf may go, with what each step costs. One order gives all levels of
/// detail, so the points of a coarser one are among those of a finer one.
struct ReductionOrder {
  std::vector<std::uint32_t> points;  ///< the one that goes first, first; all but both ends
  std::vector<double> errors;         ///< the largest until then, as a share of the length or width
};

/// The inner point goes first that is nearest to the chord between its present neighbours. Its error is
/// sqrt(e_xy^2 + e_r^2), of the distances of (x, y) and of (s, r) from their chords; `also` are further functions of s,
/// as shares of the length with a number per point, that count in the same way (the edge's height where a blade is
/// twisted). Ties: the lower index. Throws std::invalid_argument for lists of other lengths, fewer than 2 points, and
/// numbers that are not finite. Cost: n log n. Based on: Fournier and Pradal (2012), section 2.6.
ReductionOrder reduction_order(const GrassLeaf& leaf, const std::vector<std::vector<double>>& also = {});

/// The points that stay where `pieces` pieces are wanted, at least 1: indices that rise, both ends among them.
std::vector<std::uint32_t> points_kept(const ReductionOrder& order, std::size_t pieces);
/// The points that stay where no step may cost more than `error`: indices that rise, both ends among them.
std::vector<std::uint32_t> points_within(const ReductionOrder& order, double error);

/// The leaf with these points alone, wider by as much as keeps its area.
GrassLeaf reduced(const GrassLeaf& leaf, const std::vector<std::uint32_t>& points);

}  // namespace meristem
