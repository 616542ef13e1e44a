// SPDX-License-Identifier: Apache-2.0
// Where the children of a crown link stand: on a jittered grid in the crown body of a stem.
//
// Based on: F. Heuer: Algorithmische Erzeugung von 3D-Low-Poly-Bäumen (2022), 5.5.
#pragma once

#include <optional>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/graph/placement.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/graph/table/site.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// The placement keys of a crown link.
struct CrownPlacement {
  /// The direction in which children head.
  enum class Orient {
    outward,  ///< children head away from the crown's surface
    random,   ///< anywhere
  };
  double density = 30;              ///< sites per cubic metre
  Orient orient = Orient::outward;  ///< outward or random
  double turn = 0;                  ///< outward children turn aside by up to this, radians
  double droop = 0;                 ///< share of the turn that brings the heading straight down
  std::optional<double> depth;      ///< metres below the crown's surface to which children stand; unset: all through it
};

/// Returns the rows of CrownPlacement.
const ParameterTable& crown_placement_table();

/// The sites in the crown body that `surface` gives `skeleton`, which must have one. They see where they are from the
/// crown's base to its top as u, and its height as length; i and n count over all. Throws InputError past the limit of
/// instances, and Cancelled.
std::vector<Site> place_in_crown(const Skeleton& skeleton, const Surface& surface, const CrownPlacement& placement,
                                 const PlacementContext& context, Progress& progress);

}  // namespace meristem
