// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/counts.h"

#include <algorithm>

namespace meristem {

Counts count(const Plant& plant, const MeshScene& meshes) {
  Counts counts;
  counts.nodes = plant.node_count();
  for (const Stem& stem : plant.stems) {
    // Axes are numbered from 0 without gaps.
    const auto& axes = stem.skeleton.axis;
    if (!axes.empty()) counts.axes += std::uint64_t{*std::max_element(axes.begin(), axes.end())} + 1;
  }
  counts.organs = plant.organs.size();
  counts.triangles = meshes.triangle_count();
  counts.instances = meshes.instance_count();
  counts.height = meshes.bounds().size().y;
  return counts;
}

}  // namespace meristem
