// SPDX-License-Identifier: Apache-2.0
// Grows a document with one value changed, and writes plant.glb, plant.png and measures.json.
#include <cstdio>
#include <fstream>
#include <string>

#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/document/json.h"
#include "meristem/export/measure_report.h"
#include "meristem/measure/measures.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/picture/still.h"
#include "meristem/output/write/png.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("Usage: grow_document DOCUMENT NAME=VALUE\n", stderr);
    return 2;
  }
  const std::string file = argv[1];
  try {
    // Read the document with the change. One InputError carries all faults, each with its path.
    const meristem::Document document =
        meristem::read_document(meristem::read_text_file(file), file, meristem::builtin_components(),
                                {.overrides = {meristem::parse_override(argv[2])}});
    for (const meristem::Diagnostic& warning : document.warnings) std::puts(warning.text().c_str());

    // Grow. A call of progress.cancel() from another thread stops this within 50 ms.
    meristem::Progress progress;
    const meristem::GrownDocument grown = meristem::grow_document(document, progress);

    // Measure.
    const meristem::StandMeasures measures =
        meristem::measure_plant(grown.plant, document.graph.limits, grown.meshes, document.scene, {}, progress);
    std::printf("%s: %.2f m high, %.2f m2 of leaves\n", document.name.c_str(), measures.whole.height,
                measures.whole.leaf_area.value_or(0));

    // Write. A file appears whole or not at all.
    meristem::write_glb(grown.meshes, "plant.glb", {}, progress);
    std::ofstream("measures.json") << meristem::write_json(meristem::measures_value(measures, {}));
    const meristem::Image picture =
        meristem::render_still(grown.meshes, document.scene, {}, {.width = 200, .height = 200, .samples = 4}, progress);
    meristem::write_png(picture, "plant.png");
  } catch (const meristem::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const meristem::MachineError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
