// SPDX-License-Identifier: Apache-2.0
// How a level of detail divides its triangles among the parts of a plant.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "meristem/plant/plant.h"
#include "meristem/shape/detail.h"

namespace meristem {

/// The area of all triangles, square metres.
double area_of(const Mesh& mesh);

/// About how many triangles of the stem's tubes a node stands for: 2 n, for a tube of n sides. Returns 0 for a root and
/// for nodes of blended bodies. Tubes have fewer triangles where they are thin or straight.
double about_tube_triangles(const Stem& stem, NodeIndex node);

/// The shares of their triangles that the tubes and each component of organs keep at the levels 0 to `detail.level`.
/// Triangles go first where they are smallest: all parts end with triangles of about one size, and a part whose
/// triangles are larger keeps them all. Together the parts keep `detail.kept(level)`. Shares fall from level to level.
class DetailBudget {
 public:
  /// Linear in nodes and organs. A quick detail estimates areas from some triangles of each organ mesh. The plant
  /// outlives it.
  DetailBudget(const Plant& plant, const Detail& detail);

  double of_tubes(int level) const { return tubes_[static_cast<std::size_t>(level)]; }
  /// `component` has organs on the plant.
  double of_organs(std::string_view component, int level) const {
    return organs_.at(component)[static_cast<std::size_t>(level)];
  }

 private:
  std::vector<double> tubes_;
  std::map<std::string_view, std::vector<double>> organs_;
};

}  // namespace meristem
