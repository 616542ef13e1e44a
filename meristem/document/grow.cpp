// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/grow.h"

#include "meristem/graph/expand.h"

namespace meristem {

GrownDocument grow_document(const Document& document, Progress& progress, double time) {
  try {
    GrownDocument grown;
    grown.plant = expand(document.graph, document.structure, document.scene, time, progress);
    grown.meshes = make_mesh_scene(grown.plant, document.graph.limits, progress);
    return grown;
  } catch (const InputError& error) {
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    document.source.place(diagnostics);
    throw InputError(std::move(diagnostics));
  }
}

}  // namespace meristem
