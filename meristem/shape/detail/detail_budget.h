// SPDX-License-Identifier: Apache-2.0
// Divides the triangles of a level of detail among the parts of a plant.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "meristem/plant/plant.h"
#include "meristem/shape/detail/detail.h"

namespace meristem {

/// Returns the area of all triangles, square metres.
double area_of(const Mesh& mesh);

/// Returns about how many triangles of the stem's tubes belong to a node: 2 n for a tube of n sides. Returns 0 for a
/// root and for nodes of blended bodies. Thin or straight tubes have fewer triangles.
double about_tube_triangles(const Stem& stem, NodeIndex node);

/// The shares of their triangles that the tubes and each component of organs keep at levels 0 to `detail.level`.
/// Triangles are removed first where they are smallest: all parts end with triangles of about one size, and a part with
/// larger triangles keeps them all. Together the parts keep `detail.kept(level)`. Shares fall from level to level.
class DetailBudget {
 public:
  /// Computes the shares. Linear in nodes and organs. A quick detail estimates areas from some triangles of each organ
  /// mesh. The plant must outlive this object.
  DetailBudget(const Plant& plant, const MeshDetail& detail);

  double of_tubes(int level) const { return tubes_[static_cast<std::size_t>(level)]; }
  /// `component` must have organs on the plant.
  double of_organs(std::string_view component, int level) const {
    return organs_.at(component)[static_cast<std::size_t>(level)];
  }

 private:
  std::vector<double> tubes_;
  std::map<std::string_view, std::vector<double>> organs_;
};

}  // namespace meristem
