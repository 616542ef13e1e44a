// SPDX-License-Identifier: Apache-2.0
// Sets the body in its frame. The stem's own parameter `trim` decides what the body does. Nested bodies are
// intersected.
#include "meristem/components/trim.h"

#include <memory>
#include <utility>

#include "meristem/scene/crown/combined_crown.h"
#include "meristem/scene/crown/placed_crown.h"

namespace meristem {

namespace {

void expand(const Trim& trim, const Site& site, const InstanceContext& instance, SiteSink& sites) {
  Surroundings around = instance.surroundings();
  if (trim.off) around.trim = nullptr;
  if (trim.body) {
    CrownPointer body = std::make_shared<PlacedCrown>(build_crown(*trim.body), site.frame);
    if (around.trim != nullptr) {
      body = std::make_shared<CombinedCrown>(CombineKind::intersect,
                                             std::vector<CrownPointer>{std::move(around.trim), std::move(body)});
    }
    around.trim = std::move(body);
  }
  sites.surround(std::move(around));
}

}  // namespace

ComponentType trim_component() {
  return define_component<Trim>({
      .traits = {.name = "trim",
                 .doc = "A body in which the stems of everything below it are kept: a clipped hedge, a topiary, a bush "
                        "that ends at a wall.",
                 .has_geometry = false,
                 .speaks_of_space = true},
      .parameters = Table<Trim>("a trim", "A body in which stems are kept.")
                        .object("body", &Trim::body, crown_table,
                                "The body, relative to where the component stands; within another trim's body, stems "
                                "are kept in what both bodies share.")
                        .boolean("off", &Trim::off, "Whether the trims above end here; a body beside it holds alone.")
                        .check([](const Trim& trim, const DocumentPath& path, ParameterReader& reader) {
                          if (trim.body || trim.off) return;
                          reader.add_error(DocumentPath(path, "off"), "a trim that is not off has no body",
                                           "a 'body', or \"off\": true");
                        }),
      .expand = expand,
  });
}

}  // namespace meristem
