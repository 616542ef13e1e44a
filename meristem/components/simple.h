// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// A primitive of a given size on its frame, or a section of a surface that continues through its children.
struct Simple : ComponentBase {
  enum class Shape { box, sphere, cylinder, cone, torus, none, area, tube };
  Shape shape = Shape::box;
  Vec3 size{0.1F};  ///< metres: width, height, depth
  int segments = 24;
  std::vector<Vec2> outline;  ///< x and z of an area or tube, metres; empty: a line across, or an ellipse
  enum class Shading { smooth, flat } shading = Shading::smooth;  ///< of primitives
  bool cap = true;                                                ///< true: closes the ends of a tube's surface
};

ComponentType simple_component();

}  // namespace meristem
