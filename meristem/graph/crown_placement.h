// SPDX-License-Identifier: Apache-2.0
// Places the children of a crown link on a jittered grid in the crown body of a stem.
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
  double turn = 0;                  ///< largest angle to which outward children turn aside, radians
  double droop = 0;                 ///< share of the turn that brings the heading straight down
  std::optional<double> depth;      ///< depth below the crown's surface within which children stand, metres; unset: the
                                    ///< whole crown
};

/// Returns the rows of CrownPlacement.
const ParameterTable& crown_placement_table();

/// Returns the sites in the crown body that `surface` gives to `skeleton`. The surface must have a crown body. A site's
/// u is its height from the crown's base (0) to its top (1), and its length is the crown's height; i and n count over
/// all sites. Throws InputError past the limit of instances, and Cancelled.
std::vector<Site> place_in_crown(const Skeleton& skeleton, const SurfaceOptions& surface,
                                 const CrownPlacement& placement, const PlacementContext& context, Progress& progress);

}  // namespace meristem
