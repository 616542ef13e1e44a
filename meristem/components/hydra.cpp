// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/hydra.h"

#include "meristem/components/around.h"

namespace meristem {

namespace {

void expand(const Hydra& hydra, const Site&, Emitter& out) {
  out.no_children();
  const auto number = static_cast<std::uint32_t>(hydra.number);
  out.expect_children(number);
  const std::vector<double> turn = turns_around(number, hydra.arc);
  const std::vector<double> angle = out.per_child(hydra.angle, number);
  const std::vector<double> radius = out.per_child(hydra.radius, number);
  const std::vector<double> size = out.per_child(hydra.size, number);
  const std::vector<double> roll = out.per_child(hydra.roll, number);
  for (std::uint32_t k = 0; k < number; ++k) {
    Frame child{tilted(roll[k] + turn[k], angle[k]), Vec3(0)};
    child.origin = static_cast<float>(radius[k]) * child.heading();
    child.axes *= static_cast<float>(size[k]);
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
              .integer("number", &Hydra::number, {.min = 0, .max = 2e9}, "Children in the star.")
              .per_child("angle", &Hydra::angle, {.unit = Unit::degree, .min = 0, .max = 180},
                         "Between the star's heading and a child's: 0 a bundle, 90 a flat star, above it bent back.")
              .per_child("radius", &Hydra::radius, {.unit = Unit::metre, .min = 0, .max = 1000},
                         "From the middle to where a child stands.")
              .per_child("size", &Hydra::size, {.min = 0, .max = 1000}, "Scale of a child.")
              .per_child("roll", &Hydra::roll, {.unit = Unit::degree, .min = -36000, .max = 36000},
                         "Turn about the star's heading, on top of the even one.")
              .number("arc", &Hydra::arc, {.unit = Unit::degree, .min = 0, .max = 360},
                      "Of the turn over which the children are spread; below 360 a fan."),
      .expand = expand,
  });
}

}  // namespace meristem
