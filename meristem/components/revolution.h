// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"
#include "meristem/shape/solid/revolution.h"

namespace meristem {

/// A silhouette rotated about y: cones, nuts, fruits, pots. All instances share one mesh, scaled by their frames.
struct Revolution : ComponentBase {
  SolidOfRevolution body;
  enum class Shading { smooth, flat } shading = Shading::smooth;
};

ComponentType revolution_component();

}  // namespace meristem
