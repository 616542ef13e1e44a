// SPDX-License-Identifier: Apache-2.0
// Collects the meshes of a moving scene and counts their bytes against the limit.
#include "meristem/shape/moving/moving_meshes.h"

#include <algorithm>
#include <utility>

#include "meristem/shape/mesh/tangents.h"

namespace meristem {

void MovingMeshes::add(MovingMesh mesh, const std::vector<Material>& materials) {
  MeshInstances& instances = mesh.instances;
  const auto is_plain = [](Vec3 tint) { return tint == Vec3(1); };
  const bool has_tints = !mesh.motion.tints.empty();
  if (!has_tints && std::ranges::all_of(instances.tints, is_plain)) instances.tints = {};
  const auto is_first = [](std::uint32_t individual) { return individual == 0; };
  if (std::ranges::all_of(instances.individuals, is_first)) instances.individuals = {};
  instances.mesh = with_needed_tangents(instances.mesh, materials[instances.material]);
  if (mesh.motion.kind == MeshMotion::Kind::shape) {
    const std::uint64_t of_vertex = sizeof(Vec3) * (mesh.motion.turns ? 2 : 1) + (has_tints ? sizeof(Vec4) : 0);
    bytes_ += of_vertex * instances.mesh->vertex_count() * instances.frames.size() * (keys_ - 1);
    check_moving_bytes(bytes_, keys_, limits_);
  }
  meshes.push_back(std::move(mesh));
}

}  // namespace meristem
