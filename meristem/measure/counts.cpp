// SPDX-License-Identifier: Apache-2.0
// Counts what a plant consists of after it has grown. Placed plants are counted once and multiplied by the number of
// their places. The height comes from the box around all meshes.
#include "meristem/measure/counts.h"

#include <algorithm>

#include "meristem/plant/plant_variant.h"

namespace meristem {

namespace {

std::uint64_t axes_of(const Plant& plant) {
  std::uint64_t count = 0;
  for (const Stem& stem : plant.stems) {
    // Axes are numbered from 0 without gaps.
    const auto& axes = stem.skeleton.axis;
    if (!axes.empty()) count += std::uint64_t{*std::max_element(axes.begin(), axes.end())} + 1;
  }
  for (const Planting& planting : plant.plantings) count += planting.places.size() * axes_of(*planting.variant->plant);
  return count;
}

}  // namespace

PlantCounts count(const Plant& plant, const MeshScene& meshes) {
  const PlantTotals totals = totals_of(plant);
  PlantCounts counts;
  counts.nodes = totals.nodes;
  counts.axes = axes_of(plant);
  counts.organs = totals.organs;
  counts.triangles = meshes.triangle_count();
  counts.instances = meshes.instance_count();
  counts.height = meshes.bounds().size().y;
  return counts;
}

}  // namespace meristem
