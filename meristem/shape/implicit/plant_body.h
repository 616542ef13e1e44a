// SPDX-License-Identifier: Apache-2.0
// Bodies of plants. Each segment of an axis becomes a round cone, and cones blend where axes meet. Crowns become balls
// around the ends of branches. Any skeleton can be used.
//
// Based on: F. Heuer: Algorithmische Erzeugung von 3D-Low-Poly-Bäumen (2022), 5.3. In the source, all cones blend with
// each other, which swells an axis at each of its nodes. Here only different axes blend.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/plant/plant.h"
#include "meristem/shape/implicit/implicit_body.h"

namespace meristem {

/// The thickening of a blended body's axes that its cells require.
struct BodyThickening {
  double min_radius = 0;  ///< minimum radius that its cells can represent, metres
  double length = 0;      ///< length of all its axes, metres
  double thickened = 0;   ///< length of the axes that were thinner, metres
  double volume = 0;      ///< volume of the original segments, m³
  double added = 0;       ///< volume that thickening adds to the segments, m³
};

/// Returns the body of the listed axes of `skeleton`. Axes begin at their parents' nodes with their own radii. Roots
/// begin with a flat base that flares according to `surface`. Each axis blends with all thicker ones over
/// `surface.blend` times its first radius. Radii are raised to at least `min_radius` metres, and none may be NaN. The
/// body is relative to `origin`. The cost is linear in nodes.
ImplicitBody make_stem_body(const Skeleton& skeleton, std::span<const AxisIndex> axes, const SurfaceOptions& surface,
                            double min_radius, Vec3 origin = Vec3(0));

/// Returns the thickening of these axes for `surface.resolution` cells along their longest side. Without
/// `surface.thicken`, nothing is thickened.
BodyThickening find_thickening(const Skeleton& skeleton, std::span<const AxisIndex> axes,
                               const SurfaceOptions& surface);

/// Returns the nodes around which crowns have balls: nodes with a positive value in the column "end", or the tips if
/// there is no such column.
std::vector<NodeIndex> branch_ends(const Skeleton& skeleton, std::span<const AxisIndex> axes);

/// Returns the balls around these ends as one body. Empty if there are no ends.
ImplicitBody make_crown_body(const Skeleton& skeleton, std::span<const AxisIndex> axes, const CrownBody& crown,
                             Vec3 origin = Vec3(0));

}  // namespace meristem
