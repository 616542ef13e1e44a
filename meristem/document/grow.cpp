// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/grow.h"

#include "meristem/graph/expand.h"

namespace meristem {

namespace {

/// What `work` returns; places what it throws in the document's text.
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

}  // namespace

GrownDocument grow_document(const Document& document, Progress& progress, double time, const Detail& detail,
                            GrowthCache* cache) {
  GrownDocument grown;
  grown.plant = placing_faults(document, [&] {
    return expand(document.graph, document.scene, time, progress, cache != nullptr ? &cache->expansion : nullptr);
  });
  grown.meshes = mesh_detail(document, grown.plant, detail, progress, cache != nullptr ? &cache->meshes : nullptr);
  return grown;
}

MeshScene mesh_detail(const Document& document, const Plant& plant, const Detail& detail, Progress& progress,
                      MeshCache* cache) {
  return placing_faults(document,
                        [&] { return make_mesh_scene(plant, document.graph.limits, progress, detail, cache); });
}

}  // namespace meristem
