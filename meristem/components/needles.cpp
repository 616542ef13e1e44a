// SPDX-License-Identifier: Apache-2.0
// A pine has tens of thousands of shoots. Their needles are a few shared meshes: a shoot is scaled to its needles'
// length and along to its own, both exactly, after widths and lengths over the needles' length were rounded to a
// quarter and an eighth of an octave, and angles to 5°.
#include "meristem/components/needles.h"

#include <algorithm>
#include <cmath>

#include "meristem/components/parts/shared_shape.h"

namespace meristem {

namespace {

constexpr double kWidthSteps = 4;  // an octave
constexpr double kAlongSteps = 8;  // an octave
constexpr double kAxisSteps = 2;   // an octave

/// The shared shoot, with needles of length 1.
NeedleShoot shared_shoot(const NeedleShoot& exact) {
  NeedleShoot shoot = exact;
  shoot.length = 1;
  shoot.width = to_octaves(exact.width / exact.length, kWidthSteps);
  shoot.along = exact.along > 0 ? to_octaves(exact.along / exact.length, kAlongSteps) : 0;
  shoot.axis_radius = exact.axis_radius > 0 ? to_octaves(exact.axis_radius / exact.length, kAxisSteps) : 0;
  for (double NeedleShoot::*angle :
       {&NeedleShoot::base_angle, &NeedleShoot::tip_angle, &NeedleShoot::spread, &NeedleShoot::curl}) {
    shoot.*angle = to_step(exact.*angle, kShapeAngleStep);
  }
  return shoot;
}

void expand(const Needles& needles, const Site& site, Emitter& out) {
  NeedleShoot shoot = shared_shoot(needles.shoot);
  const double drawn = site.key.child("variant").uniform(0) * needles.variants;
  shoot.variant = std::min(static_cast<std::uint64_t>(drawn), static_cast<std::uint64_t>(needles.variants - 1));
  Frame frame;
  frame.axes *= static_cast<float>(needles.shoot.length);
  if (shoot.along > 0) {
    frame.axes[1] *= static_cast<float>(needles.shoot.along / (needles.shoot.length * shoot.along));
  }
  const std::uint64_t key = shape_key({shoot.width, shoot.along, shoot.axis_radius, shoot.base_angle, shoot.tip_angle,
                                       shoot.spread, shoot.curl, static_cast<double>(shoot.variant)});
  out.organ(frame, key, [&] { return make_needles(shoot); });
  out.child_site(Frame{.origin = {0, static_cast<float>(needles.shoot.along), 0}},
                 static_cast<float>(needles.shoot.along), static_cast<float>(needles.shoot.axis_radius));
}

const ParameterTable& shoot_table() {
  static const ParameterTable table =
      Table<NeedleShoot>("needles", "The needles of a shoot.")
          .integer("count", &NeedleShoot::count, {.min = 1, .max = 2000, .fixed = true}, "Needles, or bundles of them.")
          .number("length", &NeedleShoot::length, {.unit = Unit::metre, .min = 1e-4, .max = 10}, "Of a needle.")
          .number("width", &NeedleShoot::width, {.unit = Unit::metre, .min = 1e-5, .max = 1}, "Of a needle.")
          .number("along", &NeedleShoot::along, {.unit = Unit::metre, .min = 0, .max = 100},
                  "Length of the shoot that they stand on; 0: a tuft.")
          .number("base_angle", &NeedleShoot::base_angle, {.unit = Unit::degree, .min = 0, .max = 180},
                  "Between the shoot and its lowest needles.")
          .number("tip_angle", &NeedleShoot::tip_angle, {.unit = Unit::degree, .min = 0, .max = 180},
                  "Between the shoot and its highest needles.")
          .number("divergence", &NeedleShoot::divergence,
                  {.unit = Unit::degree, .min = -360, .max = 360, .fixed = true},
                  "About the shoot, from one to the next.")
          .integer("fascicle", &NeedleShoot::fascicle, {.min = 1, .max = 100, .fixed = true}, "Needles in a bundle.")
          .number("spread", &NeedleShoot::spread, {.unit = Unit::degree, .min = 0, .max = 90},
                  "Between the needles of a bundle and its middle.")
          .number("curl", &NeedleShoot::curl, {.unit = Unit::degree, .min = -120, .max = 120},
                  "Bend of a needle from base to tip; raised, it bends away from the shoot.")
          .number("flatten", &NeedleShoot::flatten, {.min = 0, .max = 1, .fixed = true},
                  "Toward both sides: 0 all around, 1 combed into one plane.")
          .number("irregular", &NeedleShoot::irregular, {.min = 0, .max = 0.9, .fixed = true},
                  "How much needles differ in length and direction, a share.")
          .integer("sides", &NeedleShoot::sides, {.min = 2, .max = 3, .fixed = true},
                   "2: flat, two triangles each; 3: spikes of three.")
          .number("axis_radius", &NeedleShoot::axis_radius, {.unit = Unit::metre, .min = 0, .max = 1},
                  "Of a thin twig along the shoot, in the needles' colour; 0: none.")
          .only_with("fascicle", {"spread"});
  return table;
}

}  // namespace

ComponentType needles_component() {
  return define_component<Needles>({
      .traits =
          {.name = "needles",
           .doc = "The needles of a shoot, or a tuft of them; it heads along y, and children stand at its tip.",
           .material = {.colour = {0.20F, 0.30F, 0.15F}, .roughness = 0.5F, .translucency = 0.15F, .two_sided = true},
           .variety = 0.1},
      .parameters = Table<Needles>("needles", "The needles of a shoot.")
                        .members(&Needles::shoot, shoot_table())
                        .integer("variants", &Needles::variants, {.min = 1, .max = 64, .fixed = true},
                                 "Different shoots, of which each instance is one; raised, more geometry."),
      .expand = expand,
  });
}

}  // namespace meristem
