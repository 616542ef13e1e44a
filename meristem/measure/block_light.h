// SPDX-License-Identifier: Apache-2.0
// Measures the light on the organs of a plant that arrives in blocks (expand_in_blocks, plant_variant.h).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/measure/foliage.h"
#include "meristem/measure/organ_light.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/scene.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// Measures the light on organs, block by block.
class BlockLight {
 public:
  /// `meshes` are the meshes of the whole plant, and `scene` contains the light. Both must outlive this object. Throws
  /// Cancelled, MachineError (memory).
  BlockLight(const MeshScene& meshes, const Scene& scene, Progress& progress);
  ~BlockLight();

  /// Returns the light on each organ of the next block. `areas` has the area of each organ. The block's meshes and
  /// textures must outlive this object. Counts organs into the caller's stage of `progress`.
  std::vector<LitOrgan> measure(const Plant& block, std::span<const OrganArea> areas, Progress& progress);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace meristem
