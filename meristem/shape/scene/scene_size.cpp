// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/scene/scene_size.h"

#include <map>
#include <memory>
#include <utility>

#include "meristem/base/large_memory.h"

namespace meristem {

namespace {

Mesh without_tangents(const Mesh& mesh) {
  Mesh lean;
  lean.positions.reserve(mesh.positions.size() + 1);  // with spare capacity, so that rays read them without a copy
  lean.positions = mesh.positions;
  lean.normals = mesh.normals;
  lean.uvs = mesh.uvs;
  lean.triangles = mesh.triangles;
  lean.stalk_triangles = mesh.stalk_triangles;
  return lean;
}

}  // namespace

std::uint64_t distinct_size(const MeshScene& scene) {
  std::uint64_t sum = 0;
  for (const MeshInstances& part : scene.meshes) sum += part.mesh->triangle_count() + part.frames.size();
  return sum;
}

void free_tangents(MeshScene& scene) {
  std::map<const Mesh*, std::shared_ptr<const Mesh>> lean;  // of meshes that several parts share
  for (MeshInstances& part : scene.meshes) {
    if (part.mesh->tangents.empty()) continue;
    const bool is_shared = part.mesh.use_count() > 1;
    std::shared_ptr<const Mesh> made;
    if (is_shared) made = lean[part.mesh.get()];
    if (made == nullptr) made = std::make_shared<const Mesh>(without_tangents(*part.mesh));
    if (is_shared) lean[part.mesh.get()] = made;
    part.mesh = std::move(made);
  }
  give_back_memory();
}

}  // namespace meristem
