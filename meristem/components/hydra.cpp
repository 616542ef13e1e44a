// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/hydra.h"

namespace meristem {

namespace {

void expand(const Hydra& hydra, const Site&, SiteSink& sites) {
  sites.no_children();
  const std::vector<ChildAround> children = children_around(member_of(hydra, &Hydra::around), sites);
  const std::vector<double> radius = sites.per_child(hydra.radius, static_cast<std::uint32_t>(children.size()));
  for (std::size_t k = 0; k < children.size(); ++k) {
    Frame child{tilted(children[k].turn, children[k].angle), Vec3(0)};
    child.origin = static_cast<float>(radius[k]) * child.heading();
    child.axes *= static_cast<float>(children[k].size);
    sites.add(child);
  }
}

}  // namespace

ComponentType hydra_component() {
  return define_component<Hydra>({
      .traits = {.name = "hydra",
                 .doc = "A star of sites for children: leaflets of a palmate leaf, petals of a blossom.",
                 .has_geometry = false},
      .parameters =
          Table<Hydra>("a hydra", "A star of sites for children.")
              .members(&Hydra::around, around_table())
              .per_child("radius", &Hydra::radius, {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0, 0.2}},
                         "Distance from the centre to the base of a child."),
      .expand = expand,
      .minimum_counts =
          [](const Hydra& hydra, const KnownMembers& known) {
            return minimum_around(member_of(hydra, &Hydra::around), known);
          },
  });
}

}  // namespace meristem
