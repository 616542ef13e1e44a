// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/wreath.h"

namespace meristem {

namespace {

void expand(const Wreath& wreath, const Site&, SiteSink& sites) {
  sites.no_children();
  const auto radius = static_cast<float>(wreath.diameter / 2);
  for (const ChildAround& place : children_around(member_of(wreath, &Wreath::around), sites)) {
    Frame child{tilted(place.turn, place.angle), Vec3(0)};
    child.origin = radius * tilted(place.turn, kPi / 2)[1];
    child.axes *= static_cast<float>(place.size);
    sites.add(child, 0, radius);
  }
}

}  // namespace

ComponentType wreath_component() {
  return define_component<Wreath>({
      .traits = {.name = "wreath",
                 .doc = "A ring of sites for children: bracts around a head, sepals around a fruit.",
                 .has_geometry = false},
      .parameters = Table<Wreath>("a wreath", "A ring of sites for children.")
                        .members(&Wreath::around, around_table())
                        .number("diameter", &Wreath::diameter, {.unit = Unit::metre, .min = 0, .max = 1000},
                                "Diameter of the ring on which the children stand."),
      .expand = expand,
      .minimum_counts =
          [](const Wreath& wreath, const KnownMembers& known) {
            return minimum_around(member_of(wreath, &Wreath::around), known);
          },
  });
}

}  // namespace meristem
