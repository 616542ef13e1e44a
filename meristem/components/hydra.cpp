// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/hydra.h"

#include "meristem/base/math.h"

namespace meristem {

namespace {

void expand(const Hydra& hydra, const Site&, Emitter& out) {
  out.no_children();
  // A full turn ends where it began; a part of one has children at both ends.
  const bool is_closed = hydra.arc >= 2 * kPi - 1e-9;
  const int gaps = is_closed ? hydra.number : hydra.number - 1;
  const double first = is_closed ? 0 : -0.5 * hydra.arc;
  for (int k = 0; k < hydra.number; ++k) {
    const double turn = hydra.roll + first + (gaps > 0 ? hydra.arc * k / gaps : 0.5 * hydra.arc);
    // Turned about the heading, then tilted away from it: the upper face looks to the star's heading.
    const Mat3 around = rotation(kUp, turn);
    Frame child;
    child.axes = around * rotation({1, 0, 0}, -hydra.angle);
    child.origin = static_cast<float>(hydra.size) * (child.axes * kUp);
    out.child_site(child);
  }
}

}  // namespace

ComponentType hydra_component() {
  return define_component<Hydra>({
      .name = "hydra",
      .doc = "A star of places for children: leaflets of a palmate leaf, petals of a blossom.",
      .parameters =
          Table<Hydra>("a hydra", "A star of places for children.")
              .integer("number", &Hydra::number, {.min = 0, .max = 100000}, "Children in the star.")
              .number("angle", &Hydra::angle, {.unit = Unit::degree, .min = 0, .max = 180},
                      "Between the star's heading and its children's: 0 a bundle, 90 a flat star, above it bent back.")
              .number("size", &Hydra::size, {.unit = Unit::metre, .min = 0, .max = 1000},
                      "From the middle to where the children stand.")
              .number("roll", &Hydra::roll, {.unit = Unit::degree, .min = -3600, .max = 3600},
                      "Turns the star about its heading.")
              .number("arc", &Hydra::arc, {.unit = Unit::degree, .min = 0, .max = 360},
                      "Of the turn over which the children are spread; below 360 a fan."),
      .expand = expand,
  });
}

}  // namespace meristem
