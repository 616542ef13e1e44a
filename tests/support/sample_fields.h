// SPDX-License-Identifier: Apache-2.0
// Implicit bodies and sampled fields for tests of meshing.
#pragma once

#include "meristem/base/function_ref.h"
#include "meristem/base/random.h"
#include "meristem/shape/implicit/implicit_body.h"
#include "meristem/shape/implicit/isosurface.h"

namespace meristem {

/// A cube of `side` values per edge, one metre apart, around the origin.
inline SampledField field_of(int side, FunctionRef<double(DVec3)> value) {
  SampledField field{.size = glm::ivec3(side), .origin = DVec3(-0.5 * (side - 1))};
  for (int k = 0; k < side * side * side; ++k) {
    const DVec3 at(k % side, k / side % side, k / (side * side));
    field.values.push_back(static_cast<float>(value(field.origin + at)));
  }
  return field;
}

/// A random solid about 1 m wide, within 2 m of the origin.
inline ImplicitBody random_solid(const RandomKey& key) {
  const DVec3 from(key.uniform(0, -1, 1), key.uniform(1, -1, 1), key.uniform(2, -1, 1));
  const DVec3 to = from + key.uniform(3, 0.1, 1) * DVec3(key.direction(4));
  const double a = key.uniform(5, 0.05, 0.5);
  const double b = key.uniform(6, 0.05, 0.5);
  const Frame frame = frame_along(Vec3(from), key.direction(7), key.direction(8));
  switch (static_cast<int>(key.uniform(9, 0, 6))) {
    case 0:
      return ImplicitBody::sphere(from, a);
    case 1:
      return ImplicitBody::capsule(from, to, a);
    case 2:
      return ImplicitBody::round_cone(from, a, to, b);
    case 3:
      return ImplicitBody::flat_cone(from, a, to, b);
    case 4:
      return ImplicitBody::box(frame, Vec3(DVec3(a, b, key.uniform(10, 0.05, 0.5))));
    default:
      return ImplicitBody::ellipsoid(frame, Vec3(DVec3(a, b, key.uniform(10, 0.05, 0.5))));
  }
}

/// Up to eight random solids combined by random operations. Some are first combined in pairs.
inline ImplicitBody random_body(const RandomKey& key) {
  ImplicitBody body = random_solid(key.child(0));
  const int count = static_cast<int>(key.uniform(1, 0, 8));
  for (int k = 1; k <= count; ++k) {
    const RandomKey draw = key.child(k);
    ImplicitBody other = random_solid(draw);
    const double width = draw.uniform(20, 0, 1);
    if (draw.uniform(21) < 0.3) other.blend(random_solid(draw.child("pair")), BlendKind::poly, 0.5 * width);
    const double which = draw.uniform(22);
    if (which < 0.15) {
      body.subtract(other);
    } else if (which < 0.2) {
      body.intersect(other);
    } else if (which < 0.4) {
      body.unite(other);
    } else {
      body.blend(other, which < 0.7 ? BlendKind::poly : which < 0.85 ? BlendKind::root : BlendKind::pasko, width);
    }
  }
  return body;
}

}  // namespace meristem
