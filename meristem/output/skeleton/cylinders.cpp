// SPDX-License-Identifier: Apache-2.0
// Turns the segments of skeletons into cylinders of equal volume, linked by parent and next cylinder.
#include "meristem/output/skeleton/cylinders.h"

#include <cmath>

#include "meristem/output/write/z_up.h"

namespace meristem {

float radius_of_equal_volume(float begin, float end) {
  const double a = begin;
  const double b = end;
  return static_cast<float>(std::sqrt((a * a + a * b + b * b) / 3));
}

float cylinder_radius(const Skeleton& skeleton, NodeIndex node) {
  const NodeIndex parent = skeleton.parent[node];
  if (parent == kNoNode || skeleton.axis[parent] != skeleton.axis[node]) return skeleton.radius[node];
  return radius_of_equal_volume(skeleton.radius[parent], skeleton.radius[node]);
}

std::vector<TreeCylinder> cylinders_of(const Plant& plant) {
  std::vector<TreeCylinder> cylinders;
  cylinders.reserve(plant.node_count());
  std::uint32_t first_axis = 0;
  std::vector<std::uint32_t> number;  // number of the cylinder that ends in each node of a stem
  for (const Stem& stem : plant.stems) {
    const Skeleton& skeleton = stem.skeleton;
    number.assign(skeleton.node_count(), kNoCylinder);
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      const AxisIndex axis = skeleton.axis[node];
      const NodeIndex parent = skeleton.parent[node];
      if (parent == kNoNode) continue;
      const bool begins = skeleton.axis[parent] != axis;
      TreeCylinder made{.begin = z_up(skeleton.position[parent]),
                        .end = z_up(skeleton.position[node]),
                        .radius = cylinder_radius(skeleton, node),
                        .parent = number[parent],
                        .axis = first_axis + axis,
                        .order = skeleton.order[node]};
      number[node] = static_cast<std::uint32_t>(cylinders.size());
      if (!begins && made.parent != kNoCylinder) {
        made.position = cylinders[made.parent].position + 1;
        cylinders[made.parent].extension = number[node];
      }
      cylinders.push_back(made);
    }
    first_axis += static_cast<std::uint32_t>(skeleton.axis_count());
  }
  return cylinders;
}

}  // namespace meristem
