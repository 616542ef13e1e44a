// SPDX-License-Identifier: Apache-2.0
// Counts the geometry of a plant.
#pragma once

#include <cstdint>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The geometry of a mesh scene.
struct GeometryCount {
  std::uint64_t triangles = 0;  ///< counted after instancing
  std::uint64_t instances = 0;  ///< of meshes
  std::uint64_t bytes = 0;      ///< memory of meshes, frames and places; a mesh counts once for each part that shows it
};

/// Counts the geometry of a scene.
GeometryCount count_geometry(const MeshScene& scene);

/// Counts the geometry that make_mesh_scene would make of a plant at level 0. Tubes are only planned. Each closed body
/// is made and freed again, so limits on triangles and on bytes of geometry apply only to closed bodies. Begins a stage
/// of `progress`, which counts plants. Throws InputError if limits are exceeded, Cancelled.
GeometryCount count_geometry(const Plant& plant, const SizeLimits& limits, Progress& progress);

}  // namespace meristem
