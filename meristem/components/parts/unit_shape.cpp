// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/unit_shape.h"

#include <algorithm>

#include "meristem/shape/solid/primitives.h"

namespace meristem {

Mesh make_unit_shape(UnitShape shape, int segments) {
  switch (shape) {
    case UnitShape::box:
      return make_box({1, 1, 1});
    case UnitShape::sphere:
      return make_sphere(0.5, segments);
    case UnitShape::cylinder:
      return make_cylinder(0.5, 1, segments);
    case UnitShape::cone:
      return make_cone(0.5, 1, segments);
    case UnitShape::torus:
      return make_torus(0.5 * (1 - kTorusTube), 0.5 * kTorusTube, segments);
  }
  return {};
}

double unit_shape_triangles(UnitShape shape, int segments) {
  switch (shape) {
    case UnitShape::box:
      return 12;
    case UnitShape::sphere:
      return 2.0 * segments * (std::max(2, segments / 2) - 1);
    case UnitShape::cylinder:
      return 4.0 * segments;
    case UnitShape::cone:
      return 2.0 * segments;
    case UnitShape::torus:
      return 2.0 * segments * std::max(3, segments / 2);
  }
  return 0;
}

Frame unit_shape_frame(UnitShape shape, Vec3 size) {
  Frame frame;
  for (int k = 0; k < 3; ++k) frame.axes[k] *= size[k];
  const bool is_centred = shape == UnitShape::sphere || shape == UnitShape::torus;
  if (shape == UnitShape::torus) frame.axes[1] /= kTorusTube;
  if (is_centred) frame.origin.y = 0.5F * size.y;
  return frame;
}

}  // namespace meristem
