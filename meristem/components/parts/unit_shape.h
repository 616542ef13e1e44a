// SPDX-License-Identifier: Apache-2.0
// Primitives that instances of any size share.
#pragma once

#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"

namespace meristem {

enum class UnitShape { box, sphere, cylinder, cone, torus };

/// The tube of a torus is this share of its width.
inline constexpr float kTorusTube = 0.25F;

/// The shape, 1 wide, with this number of corners around.
Mesh make_unit_shape(UnitShape shape, int segments);

/// Where the unit shape stands on the origin and is as wide, high and deep as `size` says.
Frame unit_shape_frame(UnitShape shape, Vec3 size);

}  // namespace meristem
