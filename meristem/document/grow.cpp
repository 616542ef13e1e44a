// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/grow.h"

#include <algorithm>
#include <utility>

#include "meristem/document/obstacle_warnings.h"
#include "meristem/graph/expand.h"
#include "meristem/graph/looks.h"

namespace meristem {

namespace {

/// What `work` returns; locates what it throws in the document's text.
template <class Work>
auto placing_faults(const Document& document, Work&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    document.source.place(diagnostics);
    throw InputError(std::move(diagnostics));
  }
}

/// Paints the textures of the plant, which its meshes share. Nothing else changes, so others may read it meanwhile.
void paint(const Document& document, GrownDocument& grown, Progress& progress, GrowthCache* cache) {
  std::vector<Material> painted = grown.plant.materials;
  paint_textures(document.graph, painted, progress, cache);
  // The materials of meshes begin with the plant's.
  for (std::vector<Material>* materials : {&grown.plant.materials, &grown.meshes.materials}) {
    const std::size_t count = std::min(painted.size(), materials->size());
    for (std::size_t m = 0; m < count; ++m) (*materials)[m].texture = painted[m].texture;
  }
}

}  // namespace

GrownDocument grow_document(const Document& document, Progress& progress, const GrowthOptions& options) {
  GrownDocument grown;
  grown.plant = placing_faults(
      document, [&] { return expand(document.graph, document.scene, options.time, progress, options.cache); });
  grown.warnings = obstacle_warnings(document.graph, document.scene.obstacles, grown.plant, progress);
  document.source.place(grown.warnings);
  complete_growth(document, grown, progress, options);
  return grown;
}

void complete_growth(const Document& document, GrownDocument& grown, Progress& progress, const GrowthOptions& options) {
  if (grown.up_to < GrownPart::meshes && options.up_to >= GrownPart::meshes) {
    grown.meshes = mesh_detail(document, grown.plant, options.detail, progress, options.cache);
    grown.up_to = GrownPart::meshes;
  }
  if (grown.up_to < GrownPart::textures && options.up_to >= GrownPart::textures) {
    paint(document, grown, progress, options.cache);
    grown.up_to = GrownPart::textures;
  }
}

MeshScene mesh_detail(const Document& document, const Plant& plant, const Detail& detail, Progress& progress,
                      GrowthCache* cache) {
  return placing_faults(document,
                        [&] { return make_mesh_scene(plant, document.graph.limits, progress, detail, cache); });
}

}  // namespace meristem
