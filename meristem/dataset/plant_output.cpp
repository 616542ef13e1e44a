// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/plant_output.h"

#include <algorithm>
#include <vector>

#include "meristem/output/formats.h"

namespace meristem {

namespace {

std::vector<PlantOutput> all_plant_outputs() {
  std::vector<PlantOutput> outputs;
  for (const Format& format : formats()) {
    outputs.push_back({.ending = std::string(format.ending),
                       .doc = std::string(format.doc),
                       .needs = format.needs,
                       .write = [&format](const PlantInHand& plant, const std::string& path, Progress& progress) {
                         format.write(plant.document, plant.grown, path, {}, progress);
                       }});
  }
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
