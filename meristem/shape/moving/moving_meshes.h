// SPDX-License-Identifier: Apache-2.0
// Moving parts of plants as moving meshes. Parts that change alike and look alike become instances of one mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/shape/moving/moving_parts.h"
#include "meristem/shape/moving/moving_scene.h"

namespace meristem {

/// One mesh of a moving scene, with its motion.
struct MovingMesh {
  MeshInstances instances;
  MeshMotion motion;
};

/// The meshes of a moving scene, with the memory that they use.
class MovingMeshes {
 public:
  MovingMeshes(const MovingLimits& limits, std::size_t keys) : limits_(limits), keys_(keys) {}

  /// Adds a mesh, without unnecessary attributes, but with the attributes that its material, one of `materials`, needs.
  /// Throws InputError if the moving data need too many bytes.
  void add(MovingMesh mesh, const std::vector<Material>& materials);

  std::vector<MovingMesh> meshes;

 private:
  const MovingLimits limits_;
  const std::size_t keys_;
  std::uint64_t bytes_ = 0;
};

/// Adds the tubes of all axes and frees the axes.
void gather_tubes(MovingParts& parts, MovingMeshes& to, Progress& progress);

/// Adds all organs and bodies and frees them. At most `rigid_instances` of them become nodes of their own.
void gather_parts(MovingParts& parts, std::size_t rigid_instances, MovingMeshes& to, Progress& progress);

}  // namespace meristem
