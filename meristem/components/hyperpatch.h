// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "meristem/components/parts/deforming.h"

namespace meristem {

struct ControlPoint {
  Vec3 at{0};  ///< metres, in the component's frame
};

/// A free-form deformation by a Bézier volume over a box.
struct Hyperpatch : ComponentBase {
  std::optional<Box> box;            ///< metres, in the component's frame; required
  std::vector<int> degree{3, 3, 3};  ///< along x, y and z
  std::vector<ControlPoint> points;  ///< in the order of BezierVolume; empty: `functions` move them from rest
  SpaceFunctions functions;
  Deforming deforming;
};

ComponentType hyperpatch_component();

}  // namespace meristem
