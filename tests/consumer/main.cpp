// SPDX-License-Identifier: Apache-2.0
// A small tree from document to picture, as a stranger's program would grow it; a header of each room.
#include <cstdio>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/graph/graph.h"
#include "meristem/grow/stand.h"
#include "meristem/measure/counts.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/picture/still.h"
#include "meristem/output/write/png.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/mesh_scene.h"

namespace {

const std::string kSapling = R"({
  "meristem": 1,
  "name": "Sapling",
  "seed": 7,
  "components": {
    "tree": {"type": "colonize", "crown": {"profile": [[0, 0.4], [0.4, 1], [0, 1.6]]}, "points": 100},
    "leaf": {"type": "leaf", "length": [0.07, 0.1]}
  },
  "links": [{"from": "tree", "to": "leaf", "kind": "branch", "density": 20}]
})";

}  // namespace

int main() {
  meristem::Progress progress;
  try {
    const meristem::Document document =
        meristem::read_document(kSapling, "sapling.json", meristem::builtin_components());
    const meristem::GrownDocument grown = meristem::grow_document(document, progress);
    const meristem::Counts counts = meristem::count(grown.plant, grown.meshes);
    std::printf("%llu nodes, %llu organs\n", static_cast<unsigned long long>(counts.nodes),
                static_cast<unsigned long long>(counts.organs));

    meristem::write_glb(grown.meshes, "sapling.glb", {}, progress);
    const meristem::Image image =
        meristem::render_still(grown.meshes, document.scene, {}, {.width = 32, .height = 32, .samples = 1}, progress);
    meristem::write_png(image, "sapling.png");
    return counts.nodes > 1 && counts.organs > 0 ? 0 : 1;
  } catch (const meristem::InputError& error) {
    std::puts(error.what());
    return 2;
  }
}
