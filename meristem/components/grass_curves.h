// SPDX-License-Identifier: Apache-2.0
// What a grass leaf component draws its leaves from: digitised points, and the curves that are fitted to them.
#pragma once

#include <optional>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/graph/component.h"

namespace meristem {

/// The curves of one leaf.
struct GrassCurves {
  /// A leaf that the source has; what has no rank or number suits all.
  struct Name {
    std::optional<int> rank;  ///< rank on the plant
    std::optional<int> leaf;  ///< number of the leaf

    bool operator==(const Name&) const = default;
  };
  std::vector<Name> leaves;  ///< that have midribs, in the order of the source
  Name leaf;                 ///< whose curves follow

  // Away from the stem and up the stem, from the collar at (0, 0), in the unit of the source.
  std::vector<Vec2> midrib_points;  ///< points of the source
  std::vector<Vec2> midrib;         ///< fitted; those of the last age, where it was measured at several
  double midrib_distance = 0;       ///< root mean square, of the points from the fitted midrib

  // Position from base (0) to tip (1), and width as a share of the largest.
  std::vector<Vec2> width_points;  ///< points of the source
  std::vector<Vec2> widths;        ///< fitted

  bool has_midrib_file = false;  ///< false: the document holds the points of the midrib
  bool has_width_file = false;   ///< false: the document holds the points of the widths
  double length = 0;             ///< metres of the blade as it was measured; 0 where no file says it
  double width = 0;              ///< metres at its widest as it was measured; 0 where no file says it
};

/// The curves of the leaf with this rank and number, or else of the first leaf of the source. Nothing for components of
/// other types. Cost: a fit. Throws what fit_midrib and fit_widths throw.
std::optional<GrassCurves> grass_curves(const Prototype& component, std::optional<int> rank, std::optional<int> leaf);

}  // namespace meristem
