// SPDX-License-Identifier: Apache-2.0
// Bodies of plants: axes become a round cone per segment, and the cones blend where axes meet; crowns become balls
// about the ends of branches. Any skeleton gives them, whatever made it.
//
// Based on: F. Heuer: Algorithmische Erzeugung von 3D-Low-Poly-Bäumen (2022), 5.3. There all cones blend with each
// other, which swells an axis at each of its nodes; here only axes blend with axes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/plant/plant.h"
#include "meristem/shape/implicit/implicit_body.h"

namespace meristem {

/// What a blended body's axes are thickened by, so that its cells can hold them.
struct Thickening {
  double least_radius = 0;  ///< metres that its cells can hold
  double length = 0;        ///< metres of all its axes
  double thickened = 0;     ///< metres of the axes that were thinner
  double volume = 0;        ///< m³ of the segments as they are
  double added = 0;         ///< m³ that thickening adds to the segments
};

/// The body of those axes of `skeleton` that are listed. Axes begin at their parents' nodes with their own radii,
/// roots with a flat base that flares as `surface` says. Each axis blends with all thicker ones over
/// `surface.blend` times its first radius. Radii are at least `least_radius` metres; none may be NaN. The body stands
/// relative to `origin`. Cost linear in nodes.
ImplicitBody make_stem_body(const Skeleton& skeleton, std::span<const AxisIndex> axes, const Surface& surface,
                            double least_radius, Vec3 origin = Vec3(0));

/// What `surface.resolution` cells along these axes' longest side mean for them; without `surface.thicken` nothing is
/// thickened.
Thickening find_thickening(const Skeleton& skeleton, std::span<const AxisIndex> axes, const Surface& surface);

/// The nodes about which crowns have balls: where the column "end" is above 0, or where there is none the tips.
std::vector<NodeIndex> branch_ends(const Skeleton& skeleton, std::span<const AxisIndex> axes);

/// The balls about those ends as one body; empty where there are none.
ImplicitBody make_crown_body(const Skeleton& skeleton, std::span<const AxisIndex> axes, const CrownBody& crown,
                             Vec3 origin = Vec3(0));

}  // namespace meristem
