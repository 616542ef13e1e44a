// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/scene/scene_size.h"

#include <cstddef>
#include <map>
#include <memory>
#include <utility>

#include "meristem/base/large_memory.h"

namespace meristem {

namespace {

constexpr std::size_t kFreedAtOnce = 64'000'000;  // bytes; freed memory of other threads is not used by the copies

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
  std::size_t freed = 0;                                    // bytes since memory was last given back
  for (MeshInstances& part : scene.meshes) {
    if (part.mesh->tangents.empty()) continue;
    // The last part that shares a mesh is its only owner, so the copy is looked up before the owners are counted.
    if (const auto known = lean.find(part.mesh.get()); known != lean.end()) {
      part.mesh = known->second;
      continue;
    }
    auto made = std::make_shared<const Mesh>(without_tangents(*part.mesh));
    if (part.mesh.use_count() > 1) lean.emplace(part.mesh.get(), made);
    freed += part.mesh->bytes();
    part.mesh = std::move(made);
    if (freed < kFreedAtOnce) continue;
    give_back_memory();
    freed = 0;
  }
  give_back_memory();
}

}  // namespace meristem
