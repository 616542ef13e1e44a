// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/limits.h"
#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// One mesh, placed any number of times.
struct MeshInstances {
  std::string component;             ///< id in the document; exports group by it
  std::shared_ptr<const Mesh> mesh;
  std::uint32_t material = 0;        ///< index into MeshScene::materials
  std::vector<Frame> frames;         ///< one an instance; rotations, uneven scales and mirrors are allowed

  std::uint64_t triangle_count() const { return mesh->triangle_count() * frames.size(); }
};

/// Meshes, materials and instances of them. Everything that leaves the program is written from it.
struct MeshScene {
  std::vector<Material> materials;
  std::vector<MeshInstances> meshes;  ///< in the order of the document's components, then of their prototypes

  std::uint64_t triangle_count() const;  ///< after instancing
  std::uint64_t instance_count() const;
  Box bounds() const;
};

/// Clothes a plant: every stem gets its surface, every prototype its instances.
/// Throws InputError where the limits on triangles or geometry would be passed, before memory is spent.
MeshScene make_mesh_scene(const Plant& plant, const Limits& limits, Progress& progress);

}  // namespace meristem
