// SPDX-License-Identifier: Apache-2.0
// The curves that a grass leaf component uses: digitised points, and the curves fitted to them.
#pragma once

#include <optional>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/graph/component.h"

namespace meristem {

/// The curves of one leaf.
struct GrassCurves {
  /// The name of a leaf in the source. A leaf without rank or number matches all ranks or numbers.
  struct Name {
    std::optional<int> rank;  ///< rank on the plant
    std::optional<int> leaf;  ///< number of the leaf

    bool operator==(const Name&) const = default;
  };
  std::vector<Name> leaves;  ///< leaves that have midribs, in the order of the source
  Name leaf;                 ///< the leaf of the following curves

  // Coordinates away from the stem and along the stem, with the collar at (0, 0), in the unit of the source.
  std::vector<Vec2> midrib_points;  ///< points of the source
  std::vector<Vec2> midrib;         ///< fitted; at the largest age if it was measured at several ages
  double midrib_distance = 0;       ///< root mean square distance of the points from the fitted midrib

  // Position from base (0) to tip (1), and width as a share of the largest width.
  std::vector<Vec2> width_points;  ///< points of the source
  std::vector<Vec2> widths;        ///< fitted

  bool has_midrib_file = false;  ///< false: the document holds the points of the midrib
  bool has_width_file = false;   ///< false: the document holds the points of the widths
  double length = 0;             ///< measured length of the blade, metres; 0 if no file contains it
  double width = 0;              ///< measured largest width, metres; 0 if no file contains it
};

/// Returns the curves of the leaf with this rank and number, or else of the first leaf of the source. Returns nothing
/// for components of other types. Cost: one fit. Throws what fit_midrib() and fit_widths() throw.
std::optional<GrassCurves> grass_curves(const Prototype& component, std::optional<int> rank, std::optional<int> leaf);

}  // namespace meristem
