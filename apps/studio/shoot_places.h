// SPDX-License-Identifier: Apache-2.0
// Places on the shoots of a plant: found by a point, by name, or beside another shoot in the tree.
#pragma once

#include <string>

#include "meristem/base/vec.h"
#include "meristem/plant/plant.h"
#include "request.h"

namespace meristem::studio {

/// A place on a shoot. Where there is none, `stem` is null.
struct ShootPlace {
  const Stem* stem = nullptr;
  AxisIndex axis = 0;
  NodeIndex node = 0;  ///< on the axis, or the node that the axis springs from
};

/// The place on a component's stems that is nearest to a point, measured from their surfaces: the nearer end of the
/// nearest segment.
ShootPlace nearest_shoot(const Plant& plant, const std::string& component, Vec3 point);

/// The shoot that the request names, or the one that stands beside it on the way that the request goes. Cost linear in
/// the nodes of the plant.
ShootPlace wished_shoot(const Plant& plant, const ShootRequest& request);

}  // namespace meristem::studio
