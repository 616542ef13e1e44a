// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/plant_output.h"

#include <algorithm>
#include <vector>

#include "meristem/export/formats.h"
#include "meristem/export/scan/scan_request.h"
#include "meristem/output/scan/scan_files.h"

namespace meristem {

namespace {

/// Returns the scan of the settings, with noise from the plant's own seed.
ScanPlan scan_plan_of(const PlantInHand& plant) { return plan_scan(plant.settings, plant.document.graph.seed); }

/// Returns the output of scans in a format. Its ending is for example ".scan.las".
PlantOutput scan_output(const ScanFormat& format) {
  return {.ending = ".scan" + std::string(format.ending),
          .doc = "a scan of the plant with the truth of each point: " + std::string(format.doc),
          .needs = GrownPart::textures,  // pulses pass through the holes of textures
          .write =
              [](const PlantInHand& plant, const std::string& path, Progress& progress) {
                const ScanPlan plan = scan_plan_of(plant);
                const MeshScene meshes = scanned_meshes(plant.grown.meshes, plant.document.scene.obstacles, plan);
                const Scanner scanner(plant.grown.plant, plant.document.graph.limits, meshes, plan.options, progress);
                write_scan(scanner, std::span(&path, 1), provenance_of(plant.document), progress);
              },
          .settings = scan_table,
          .check = [](const Value& settings) { plan_scan(settings, 0); }};
}

std::vector<PlantOutput> all_plant_outputs() {
  std::vector<PlantOutput> outputs;
  for (const FileFormat& format : formats()) {
    outputs.push_back({.ending = std::string(format.ending),
                       .doc = std::string(format.doc),
                       .needs = format.needs,
                       .request = format.request,
                       .write = [&format](const PlantInHand& plant, const std::string& path, Progress& progress) {
                         format.write(plant.document, plant.grown, path, {}, progress);
                       }});
  }
  for (const ScanFormat& format : scan_formats()) outputs.push_back(scan_output(format));
  return outputs;
}

}  // namespace

std::span<const PlantOutput> plant_outputs() {
  static const std::vector<PlantOutput> outputs = all_plant_outputs();
  return outputs;
}

const PlantOutput* find_plant_output(const std::string& ending) {
  const auto outputs = plant_outputs();
  const auto found =
      std::find_if(outputs.begin(), outputs.end(), [&](const PlantOutput& output) { return output.ending == ending; });
  return found == outputs.end() ? nullptr : &*found;
}

}  // namespace meristem
