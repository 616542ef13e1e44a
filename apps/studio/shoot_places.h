// SPDX-License-Identifier: Apache-2.0
// Positions on the shoots of a plant, found by a point, by name, or from a neighbouring shoot.
#pragma once

#include <string>

#include "meristem/base/vec.h"
#include "meristem/plant/plant.h"
#include "request.h"

namespace meristem::studio {

/// A position on a shoot. `stem` is null if there is no such position.
struct ShootPlace {
  const Stem* stem = nullptr;
  AxisIndex axis = 0;
  NodeIndex node = 0;  ///< node on the axis, or the node from which the axis branches off
};

/// Returns the position on a component's stems that is nearest to a point: the nearer end of the nearest segment.
/// Distances are measured from the stems' surfaces.
ShootPlace nearest_shoot(const Plant& plant, const std::string& component, Vec3 point);

/// Returns the shoot that the request names, or its neighbour in the requested direction. Takes time in proportion to
/// the nodes of the plant.
ShootPlace requested_shoot(const Plant& plant, const ShootRequest& request);

}  // namespace meristem::studio
