// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/wreath.h"

#include "meristem/components/around.h"

namespace meristem {

namespace {

void expand(const Wreath& wreath, const Site&, Emitter& out) {
  out.no_children();
  const auto number = static_cast<std::uint32_t>(wreath.number);
  out.expect_children(number);
  const std::vector<double> turn = turns_around(number, wreath.arc);
  const std::vector<double> angle = out.per_child(wreath.angle, number);
  const std::vector<double> size = out.per_child(wreath.size, number);
  const std::vector<double> roll = out.per_child(wreath.roll, number);
  const auto radius = static_cast<float>(wreath.diameter / 2);
  for (std::uint32_t k = 0; k < number; ++k) {
    Frame child{tilted(roll[k] + turn[k], angle[k]), Vec3(0)};
    child.origin = radius * tilted(roll[k] + turn[k], kPi / 2)[1];
    child.axes *= static_cast<float>(size[k]);
    out.child_site(child, 0, radius);
  }
}

}  // namespace

ComponentType wreath_component() {
  return define_component<Wreath>({
      .name = "wreath",
      .doc = "A ring of places for children: bracts about a head, sepals about a fruit.",
      .parameters =
          Table<Wreath>("a wreath", "A ring of places for children.")
              .integer("number", &Wreath::number, {.min = 0, .max = 2e9}, "Children on the ring.")
              .number("diameter", &Wreath::diameter, {.unit = Unit::metre, .min = 0, .max = 1000}, "Of the ring.")
              .per_child("angle", &Wreath::angle, {.unit = Unit::degree, .min = 0, .max = 180},
                         "Between the ring's heading and a child's: 0 along it, 90 outward, above it bent back.")
              .per_child("size", &Wreath::size, {.min = 0, .max = 1000}, "Scale of a child.")
              .per_child("roll", &Wreath::roll, {.unit = Unit::degree, .min = -36000, .max = 36000},
                         "Turn about the ring's heading, on top of the even one.")
              .number("arc", &Wreath::arc, {.unit = Unit::degree, .min = 0, .max = 360},
                      "Of the ring over which the children are spread; below 360 a part of it."),
      .expand = expand,
  });
}

}  // namespace meristem
