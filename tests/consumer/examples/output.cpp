// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <string>

#include "examples.h"
#include "meristem/components/registry.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/measure/measures.h"
#include "meristem/measure/scan/scan.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/picture/still.h"
#include "meristem/output/skeleton/skeleton_table.h"
#include "meristem/output/write/png.h"

using namespace meristem;

namespace {

Document sapling() { return read_document(kSapling, "sapling.json", builtin_components()); }

// Example of MeshScene: the triangles of a plant, by component.
void mesh_scene() {
  Progress progress;
  const GrownDocument grown = grow_document(sapling(), progress);
  std::uint64_t leaves = 0;
  for (const MeshInstances& part : grown.meshes.meshes) {
    if (part.component == "leaf") leaves += part.count();
  }
  expect(leaves == 12);
  expect(grown.meshes.bounds().high.y > 0.5F);
}

// Example of Measures: the height and the leaf area of a plant.
void measures() {
  Progress progress;
  const Document document = sapling();
  const GrownDocument grown = grow_document(document, progress);
  const Measures whole =
      measure_plant(grown.plant, document.graph.limits, grown.meshes, document.scene, {}, progress).whole;
  expect(std::abs(whole.height - 0.5) < 0.01);                       // metres
  expect(whole.leaf_count == 12 && whole.leaf_area.value() > 0.01);  // square metres
}

// Example of Scan: the points that a scanner sees of a plant, from one position.
void scanned() {
  Progress progress;
  const Document document = sapling();
  const GrownDocument grown = grow_document(document, progress);
  ScanOptions options;
  options.instrument.step = radians(0.2);
  options.stations = {{3, 0.5F, 0}};  // metres
  const Scan seen = scan(grown.plant, document.graph.limits, grown.meshes, options, progress);
  expect(!seen.points.empty());
  for (const ScanPoint& point : seen.points) expect(point.true_range > 2 && point.true_range < 4);
}

// Example of GltfOptions: a plant as a file for other programs.
void gltf() {
  Progress progress;
  const GrownDocument grown = grow_document(sapling(), progress);
  write_glb(grown.meshes, "sapling.glb", GltfOptions{.instances = GltfInstances::automatic}, progress);
  expect(std::filesystem::file_size("sapling.glb") > 1000);
}

// Example of StillOptions: a picture of a plant, 64 pixels wide.
void still() {
  Progress progress;
  const Document document = sapling();
  const GrownDocument grown = grow_document(document, progress);
  const Image picture =
      render_still(grown.meshes, document.scene, CameraView(), {.width = 64, .height = 64, .samples = 4}, progress);
  write_png(picture, "sapling.png");
}

// Example of SkeletonTable: the nodes of all stems as a table.
void skeleton_table() {
  Progress progress;
  const GrownDocument grown = grow_document(sapling(), progress, {.up_to = GrownPart::plant});
  const SkeletonTable table(grown.plant);
  std::size_t roots = 0;
  table.for_each_row(0, table.row_count(), [&](const SkeletonRow& row) {
    if (table.parent(row) == SkeletonTable::kNoRow) ++roots;
  });
  expect(roots == 1 && table.row_count() == grown.plant.node_count());
}

// Example of DatasetPlan: six saplings of two heights, which are not grown yet.
void dataset_plan() {
  const DatasetPlan plan = read_dataset_plan(
      R"({"meristem_dataset": 1, "name": "Saplings", "documents": ["sapling"], "seeds": 3,
          "grid": {"tall": [0.5, 1]}, "files": [".glb"], "measures": ["height"]})",
      "saplings.json", builtin_components(),
      {.documents = {{.name = "sapling", .text = kSapling, .file = "sapling.json", .set = {}}}});
  expect(plan.count() == 6);
  expect(plan.plant(5).number == 5 && plan.plant(5).values[0].first == "tall");
}

}  // namespace

void output_examples() {
  mesh_scene();
  measures();
  scanned();
  gltf();
  still();
  skeleton_table();
  dataset_plan();
}
