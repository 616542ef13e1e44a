// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/plant_bounds.h"

#include <vector>

#include <glm/common.hpp>

#include "meristem/plant/plant_variant.h"

namespace meristem {

Box box_in(const Box& box, const Frame& frame) {
  if (box.is_empty()) return box;
  const Vec3 centre = frame.point(box.centre());
  const Vec3 half = 0.5F * box.size();
  const Vec3 reach =
      glm::abs(frame.axes[0]) * half.x + glm::abs(frame.axes[1]) * half.y + glm::abs(frame.axes[2]) * half.z;
  return {centre - reach, centre + reach};
}

Box bounds(const Plant& plant) {
  Box box;
  for (const Stem& stem : plant.stems) box.add(bounds(stem.skeleton));
  std::vector<Box> of_prototype(plant.prototypes.size());
  for (std::size_t k = 0; k < plant.prototypes.size(); ++k) {
    for (const Vec3 position : plant.prototypes[k].mesh->positions) of_prototype[k].add(position);
  }
  for (const Organ& organ : plant.organs) box.add(box_in(of_prototype[organ.prototype], organ.frame));
  for (const Planting& planting : plant.plantings) {
    const Box of_variant = bounds(*planting.variant->plant);
    for (const Planting::Place& place : planting.places) box.add(box_in(of_variant, place.frame));
  }
  return box;
}

}  // namespace meristem
