// SPDX-License-Identifier: Apache-2.0
// Needles with shared meshes, because a pine has tens of thousands of shoots. A shoot is scaled exactly to the length
// of its needles and to its own length. Before that, widths are rounded to a quarter of an octave of the needles'
// length and lengths to an eighth. Angles that vary between shoots are rounded to 5°.
#include "meristem/components/needles.h"

#include <algorithm>
#include <cmath>

#include "meristem/components/parts/shared_shape.h"

namespace meristem {

namespace {

constexpr double kWidthSteps = 4;  // per octave
constexpr double kAlongSteps = 8;  // per octave
constexpr double kAxisSteps = 2;   // per octave

/// Returns the shared shoot, with needles of length 1.
NeedleShoot shared_shoot(const Needles& needles, const InstanceContext& instance) {
  const NeedleShoot& exact = needles.shoot;
  NeedleShoot shoot = exact;
  shoot.length = 1;
  shoot.width = to_octaves(exact.width / exact.length, kWidthSteps);
  shoot.along = exact.along > 0 ? to_octaves(exact.along / exact.length, kAlongSteps) : 0;
  shoot.axis_radius = exact.axis_radius > 0 ? to_octaves(exact.axis_radius / exact.length, kAxisSteps) : 0;
  for (double NeedleShoot::*angle :
       {&NeedleShoot::base_angle, &NeedleShoot::tip_angle, &NeedleShoot::spread, &NeedleShoot::curl}) {
    if (instance.varies(member_of(needles, &Needles::shoot, angle)))
      shoot.*angle = to_step(exact.*angle, kShapeAngleStep);
  }
  return shoot;
}

void expand(const Needles& needles, const Site& site, const InstanceContext& instance, OrganSink& organs,
            SiteSink& sites) {
  NeedleShoot shoot = shared_shoot(needles, instance);
  const double drawn = site.key.child("variant").uniform(0) * needles.variants;
  shoot.variant = std::min(static_cast<std::uint64_t>(drawn), static_cast<std::uint64_t>(needles.variants - 1));
  Frame frame;
  frame.axes *= static_cast<float>(needles.shoot.length);
  if (shoot.along > 0) {
    frame.axes[1] *= static_cast<float>(needles.shoot.along / (needles.shoot.length * shoot.along));
  }
  const std::uint64_t key = shape_key({shoot.width, shoot.along, shoot.axis_radius, shoot.base_angle, shoot.tip_angle,
                                       shoot.spread, shoot.curl, static_cast<double>(shoot.variant)});
  organs.add(frame, key, [&] { return make_needles(shoot); });
  sites.add(Frame{.origin = {0, static_cast<float>(needles.shoot.along), 0}}, static_cast<float>(needles.shoot.along),
            static_cast<float>(needles.shoot.axis_radius));
}

const ParameterTable& shoot_table() {
  static const ParameterTable table =
      Table<NeedleShoot>("needles", "The needles of a shoot.")
          .integer("count", &NeedleShoot::count, {.min = 1, .max = 2000, .usual = {1, 200}, .fixed = true},
                   "Number of bundles of needles along the shoot; single needles where 'fascicle' is 1.")
          .number("length", &NeedleShoot::length, {.unit = Unit::metre, .min = 1e-4, .max = 10, .usual = {0.005, 0.3}},
                  "Length of a needle.")
          .number("width", &NeedleShoot::width, {.unit = Unit::metre, .min = 1e-5, .max = 1, .usual = {0.0003, 0.005}},
                  "Width of a needle at its middle.")
          .number("along", &NeedleShoot::along, {.unit = Unit::metre, .min = 0, .max = 100},
                  "Length of the shoot that bears the needles; 0 makes a tuft that springs from one point.")
          .number("base_angle", &NeedleShoot::base_angle, {.unit = Unit::degree, .min = 0, .max = 180},
                  "Angle between the shoot and its lowest needles; raised, they stand off more.")
          .number("tip_angle", &NeedleShoot::tip_angle, {.unit = Unit::degree, .min = 0, .max = 180},
                  "Angle between the shoot and its highest needles; raised, they stand off more.")
          .number("divergence", &NeedleShoot::divergence,
                  {.unit = Unit::degree, .min = -360, .max = 360, .usual = {0, 180}, .fixed = true},
                  "Divergence angle: the turn about the shoot from one bundle to the next.")
          .integer("fascicle", &NeedleShoot::fascicle, {.min = 1, .max = 100, .fixed = true},
                   "Number of needles per bundle (fascicle): 2 to 5 in pines, 1 in spruces and firs.")
          .number("spread", &NeedleShoot::spread, {.unit = Unit::degree, .min = 0, .max = 90},
                  "Angle between a bundle's middle and its outer needles; raised, the bundle opens.")
          .number("curl", &NeedleShoot::curl, {.unit = Unit::degree, .min = -120, .max = 120},
                  "Bend of a needle from base to tip; raised, it bends away from the shoot.")
          .number("flatten", &NeedleShoot::flatten, {.min = 0, .max = 1, .fixed = true},
                  "Flattening of the needles: 0 leaves them all around the shoot, 1 combs them to both sides into one "
                  "plane.")
          .number("irregular", &NeedleShoot::irregular, {.min = 0, .max = 0.9, .usual = {0, 0.5}, .fixed = true},
                  "Random variation of the needles' length and direction, as a share; raised, a rougher shoot.")
          .integer("sides", &NeedleShoot::sides, {.min = 2, .max = 3, .fixed = true},
                   "Number of sides of a needle: 2 makes a flat needle of two triangles, 3 a spike of three.")
          .number("axis_radius", &NeedleShoot::axis_radius,
                  {.unit = Unit::metre, .min = 0, .max = 1, .usual = {0, 0.01}},
                  "Radius of a thin twig along the shoot, in the colour of the needles; 0 makes none.")
          .only_with("fascicle", {"spread"});
  return table;
}

}  // namespace

ComponentType needles_component() {
  return define_component<Needles>({
      .traits =
          {.name = "needles",
           .doc = "The needles of a shoot, or a tuft of them; the shoot heads along y, and children stand at its tip.",
           .material = {.colour = {0.20F, 0.30F, 0.15F}, .roughness = 0.5F, .translucency = 0.15F, .two_sided = true},
           .variety = 0.1},
      .parameters =
          Table<Needles>("needles", "The needles of a shoot.")
              .members(&Needles::shoot, shoot_table())
              .integer("variants", &Needles::variants, {.min = 1, .max = 64, .fixed = true},
                       "Number of different shoots that the instances share; raised, more variety and more geometry."),
      .expand = expand,
      .minimum_triangles =
          [](const Needles& needles, const KnownMembers&) {
            return 1.0 * needles.shoot.count * needles.shoot.fascicle * (needles.shoot.sides == 2 ? 2 : 3);
          },
  });
}

}  // namespace meristem
