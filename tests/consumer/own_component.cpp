// SPDX-License-Identifier: Apache-2.0
// A new component type, which documents use beside all others; it is checked, varied and documented like them.
#include <cstdio>
#include <string>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/graph/component.h"
#include "meristem/output/mesh/obj.h"
#include "meristem/shape/solid/primitives.h"

namespace {

/// A thorn that carries a ring of children near its tip. Metres and radians.
struct Thorn : meristem::ComponentBase {
  double length = 1;
  double radius = 0.05;
  int number = 3;
  double opening = meristem::radians(40);
};

/// Expands one instance in its own frame; y points along the thorn.
void expand(const Thorn& thorn, const meristem::Site&, meristem::OrganSink& organs, meristem::SiteSink& sites) {
  // Thorns of equal slimness share a mesh; each scales it to its length.
  const double slimness = thorn.radius / thorn.length;
  meristem::Frame stretched;
  stretched.axes *= static_cast<float>(thorn.length);
  organs.add(stretched, meristem::shape_key({slimness}), [&] { return meristem::make_cone(slimness, 1, 8); });
  sites.no_children();  // except the children of the ring below
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
              .number("length", &Thorn::length, {.unit = Unit::metre, .min = 0.001, .max = 10}, "Length of the thorn.")
              .number("radius", &Thorn::radius, {.unit = Unit::metre, .min = 1e-5, .max = 1}, "Radius at the base.")
              .integer("number", &Thorn::number, {.min = 0, .max = 100}, "Number of children in the ring.")
              .number("opening", &Thorn::opening, {.unit = Unit::degree, .min = 0, .max = 180},
                      "Angle between the thorn and each child."),
      .expand = expand,
  });
}

const std::string kDocument = R"({
  "meristem": 1,
  "variables": {"arms": 3},
  "components": {
    "thorn": {"type": "thorn", "number": "arms", "recursion": 3, "length": "0.5 ^ depth", "radius": [0.02, 0.05]},
    "fruit": {"type": "simple", "shape": "sphere", "size": [0.04, 0.04, 0.04], "colour": "#b03020"}
  },
  "links": [["thorn", "thorn"], {"from": "thorn", "to": "fruit", "kind": "leaf"}]
})";

}  // namespace

int main() {
  const auto builtin = meristem::builtin_components().types();
  std::vector<meristem::ComponentType> types(builtin.begin(), builtin.end());
  types.push_back(thorn_component());
  const meristem::Registry registry(std::move(types));

  meristem::Progress progress;
  const meristem::Document document = meristem::read_document(kDocument, "thorns.json", registry);
  const meristem::GrownDocument grown = meristem::grow_document(document, progress);
  std::printf("%zu organs\n", grown.plant.organs.size());
  meristem::write_obj(grown.meshes, "thorns.obj", {}, progress);
  return grown.plant.organs.size() == 1 + 3 + 9 + 27 ? 0 : 1;
}
