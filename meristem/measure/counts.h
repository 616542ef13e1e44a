// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "meristem/plant/plant.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The sizes that all programs report after growing.
struct PlantCounts {
  std::uint64_t nodes = 0;      ///< nodes of all skeletons
  std::uint64_t axes = 0;       ///< axes of all skeletons
  std::uint64_t organs = 0;     ///< organs
  std::uint64_t triangles = 0;  ///< after instancing
  std::uint64_t instances = 0;  ///< surfaces of stems, and organs
  double height = 0;            ///< metres from the lowest to the highest point of the meshes
};

/// Counts what has grown, and measures how high it is.
PlantCounts count(const Plant& plant, const MeshScene& meshes);

}  // namespace meristem
