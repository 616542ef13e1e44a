// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/simple.h"

#include "meristem/shape/primitives.h"

namespace meristem {

namespace {

Mesh make_unit_shape(const Simple& simple) {
  switch (simple.shape) {
    case Simple::Shape::box:
      return make_box({1, 1, 1});
    case Simple::Shape::sphere:
      return make_sphere(0.5, simple.segments);
    case Simple::Shape::cylinder:
      return make_cylinder(0.5, 1, simple.segments);
    case Simple::Shape::cone:
      return make_cone(0.5, 1, simple.segments);
    case Simple::Shape::torus:
      return make_torus(0.5 * (1 - kTorusTube), 0.5 * kTorusTube, simple.segments);
  }
  return {};
}

/// The unit shape stands in the unit cube on the origin, and the instance stretches it to its size.
void expand(const Simple& simple, const Site&, Emitter& out) {
  Frame frame;
  for (int k = 0; k < 3; ++k) frame.axes[k] *= simple.size[k];
  const bool centred = simple.shape == Simple::Shape::sphere || simple.shape == Simple::Shape::torus;
  if (simple.shape == Simple::Shape::torus) frame.axes[1] /= kTorusTube;
  if (centred) frame.origin.y = 0.5F * simple.size.y;
  out.organ(frame, shape_key({static_cast<double>(simple.shape), static_cast<double>(simple.segments)}),
            [&] { return make_unit_shape(simple); });
  Frame top;
  top.origin.y = simple.size.y;
  out.child_site(top, simple.size.y, 0.5F * simple.size.x);
}

}  // namespace

ComponentType simple_component() {
  return define_component<Simple>({
      .name = "simple",
      .doc = "A box, sphere, cylinder, cone or torus that stands on its frame; children stand on top.",
      .parameters =
          Table<Simple>("a simple", "A box, sphere, cylinder, cone or torus that stands on its frame.")
              .choice("shape", &Simple::shape, {"box", "sphere", "cylinder", "cone", "torus"}, "The primitive.")
              .vector("size", &Simple::size, {.unit = Unit::metre, .min = 1e-6, .max = 1e4},
                      "Width (x), height (y) and depth (z).")
              .integer("segments", &Simple::segments, {.min = 3, .max = 512},
                       "Corners around; raised, rounder and heavier."),
      .material = {.colour = {0.69F, 0.66F, 0.61F}, .roughness = 0.8F},
      .expand = expand,
  });
}

}  // namespace meristem
