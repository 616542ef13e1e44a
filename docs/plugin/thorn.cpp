// SPDX-License-Identifier: Apache-2.0
// A component type of one's own as a plug-in: documents use it beside all others, and it is checked, varied and listed
// like them.
#include "meristem/base/frame.h"
#include "meristem/components/plugin.h"
#include "meristem/shape/solid/primitives.h"

namespace {

/// A thorn that carries a ring of children near its tip. Metres and radians.
struct Thorn : meristem::ComponentBase {
  double length = 1;
  double radius = 0.05;
  int number = 3;
  double opening = meristem::radians(40);
};

/// One instance, in its own frame: y along it.
void expand(const Thorn& thorn, const meristem::Site&, meristem::OrganSink& organs, meristem::SiteSink& sites) {
  // Thorns of one form share a mesh, which each scales to its length.
  const double slimness = thorn.radius / thorn.length;
  meristem::Frame stretched;
  stretched.axes *= static_cast<float>(thorn.length);
  organs.add(stretched, meristem::shape_key({slimness}), [&] { return meristem::make_cone(slimness, 1, 8); });
  sites.no_children();  // but those below
  for (int k = 0; k < thorn.number; ++k) {
    meristem::Frame child;
    child.axes = meristem::rotation({0, 1, 0}, 2 * meristem::kPi * k / thorn.number) *
                 meristem::rotation({1, 0, 0}, thorn.opening);
    child.origin.y = static_cast<float>(0.9 * thorn.length);
    sites.add(child, static_cast<float>(thorn.length));
  }
}

meristem::ComponentType thorn_component() {
  using meristem::Unit;
  const std::string doc = "A thorn with a ring of children near its tip.";
  return meristem::define_component<Thorn>({
      .traits = {.name = "thorn", .doc = doc},
      .parameters =
          meristem::Table<Thorn>("a thorn", doc)
              .number("length", &Thorn::length, {.unit = Unit::metre, .min = 0.001, .max = 10}, "Base to tip.")
              .number("radius", &Thorn::radius, {.unit = Unit::metre, .min = 1e-5, .max = 1}, "Radius at the base.")
              .integer("number", &Thorn::number, {.min = 0, .max = 100}, "Number of children in the ring.")
              .number("opening", &Thorn::opening, {.unit = Unit::degree, .min = 0, .max = 180},
                      "Angle between the thorn and each child; raised, children stand off more."),
      .expand = expand,
  });
}

}  // namespace

MERISTEM_PLUGIN(thorn_component())
