// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/gltf_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "meristem/base/parallel.h"

namespace meristem {

namespace {

const Frame kIdentity[1] = {Frame{}};

constexpr std::size_t kVerticesPerBlock = 1 << 15;

/// Adds a piece to the mesh's primitive of the same material and attributes, or to a new one.
void add_piece(GltfMesh& mesh, std::uint32_t material, GltfPiece piece) {
  const bool has_normals = !piece.mesh->normals.empty();
  const bool has_uvs = !piece.mesh->uvs.empty();
  const auto fits = [&](const GltfPrimitive& primitive) {
    return primitive.material == material && primitive.has_normals == has_normals && primitive.has_uvs == has_uvs;
  };
  auto primitive = std::find_if(mesh.primitives.begin(), mesh.primitives.end(), fits);
  if (primitive == mesh.primitives.end()) {
    GltfPrimitive fresh;
    fresh.material = material;
    fresh.has_normals = has_normals;
    fresh.has_uvs = has_uvs;
    primitive = mesh.primitives.insert(mesh.primitives.end(), std::move(fresh));
  }
  primitive->vertices += piece.vertex_count();
  primitive->triangles += piece.triangle_count();
  primitive->pieces.push_back(piece);
}

void bake(GltfLayout& layout, std::size_t component, const MeshInstances& instances, std::span<const Frame> frames) {
  std::size_t& mesh = layout.components[component].baked_mesh;
  if (mesh == GltfComponent::kNoMesh) {
    mesh = layout.meshes.size();
    layout.meshes.push_back({instances.component, {}});
  }
  add_piece(layout.meshes[mesh], instances.material, {instances.mesh.get(), frames});
}

/// The index of the layout's mesh that is `instances.mesh` alone, in its own coordinates and material.
std::size_t shared_mesh(GltfLayout& layout, const MeshInstances& instances) {
  layout.meshes.push_back({instances.component, {}});
  add_piece(layout.meshes.back(), instances.material, {instances.mesh.get(), kIdentity});
  return layout.meshes.size() - 1;
}

void share(GltfLayout& layout, std::size_t component, const MeshInstances& instances) {
  std::vector<Frame> inexpressible;
  std::copy_if(instances.frames.begin(), instances.frames.end(), std::back_inserter(inexpressible),
               [](const Frame& frame) { return !is_expressible_as_node(frame); });
  if (inexpressible.size() < instances.frames.size()) {
    layout.components[component].shared.push_back({shared_mesh(layout, instances), instances.frames});
  }
  if (!inexpressible.empty()) {
    layout.inexpressible_frames.push_back(std::move(inexpressible));
    bake(layout, component, instances, layout.inexpressible_frames.back());
  }
}

/// Takes the next `bytes` of the binary chunk; every array begins at a multiple of 4.
GltfRange take(GltfLayout& layout, std::uint64_t bytes) {
  const GltfRange range{layout.binary_bytes, bytes};
  layout.binary_bytes += (bytes + 3) / 4 * 4;
  return range;
}

void place_arrays(GltfLayout& layout) {
  for (GltfMesh& mesh : layout.meshes) {
    for (GltfPrimitive& primitive : mesh.primitives) {
      primitive.index_range = take(layout, primitive.triangles * (primitive.has_wide_indices() ? 12 : 6));
      primitive.position_range = take(layout, primitive.vertices * sizeof(Vec3));
      if (primitive.has_normals) primitive.normal_range = take(layout, primitive.vertices * sizeof(Vec3));
      if (primitive.has_uvs) primitive.uv_range = take(layout, primitive.vertices * sizeof(Vec2));
    }
  }
}

std::uint64_t total_triangles(const MeshScene& scene) {
  std::uint64_t total = 0;
  for (const MeshInstances& instances : scene.meshes) total += instances.triangle_count();
  return total;
}

Box bounds_of(const GltfPiece& piece, Progress& progress) {
  const std::size_t vertices = piece.mesh->vertex_count();
  const std::size_t frames_per_block = std::max<std::size_t>(1, kVerticesPerBlock / vertices);
  const std::size_t blocks = (piece.frames.size() + frames_per_block - 1) / frames_per_block;
  std::vector<Box> boxes(blocks);
  parallel_for(piece.frames.size(), frames_per_block, [&](std::size_t begin, std::size_t end) {
    progress.check();
    Box& box = boxes[begin / frames_per_block];
    for (std::size_t f = begin; f < end; ++f) {
      for (const Vec3 position : piece.mesh->positions) box.add(piece.frames[f].point(position));
    }
  });
  Box all;
  for (const Box& box : boxes) all.add(box);
  return all;
}

}  // namespace

bool is_expressible_as_node(const Frame& frame) {
  const Mat3& axes = frame.axes;
  const float x = glm::length(axes[0]);
  const float y = glm::length(axes[1]);
  const float z = glm::length(axes[2]);
  constexpr float kFlat = 1e-12F;
  if (!(x > kFlat && y > kFlat && z > kFlat)) return false;
  // Products of float rotations drift by about 1e-6; a shear that anybody meant is larger.
  constexpr float kShear = 4e-6F;
  return std::abs(glm::dot(axes[0], axes[1])) <= kShear * x * y &&
         std::abs(glm::dot(axes[1], axes[2])) <= kShear * y * z &&
         std::abs(glm::dot(axes[2], axes[0])) <= kShear * z * x;
}

GltfLayout lay_out_gltf(const MeshScene& scene, std::uint64_t flatten_triangles) {
  GltfLayout layout;
  std::map<std::string_view, std::size_t> component_indices;
  const bool bakes_all = total_triangles(scene) <= flatten_triangles;
  for (const MeshInstances& instances : scene.meshes) {
    if (instances.triangle_count() == 0) continue;
    const auto [entry, is_new] = component_indices.try_emplace(instances.component, layout.components.size());
    if (is_new) layout.components.push_back({instances.component, GltfComponent::kNoMesh, {}});
    const std::size_t component = entry->second;
    layout.materials.push_back(instances.material);
    if (bakes_all || instances.frames.size() == 1) {
      bake(layout, component, instances, instances.frames);
    } else {
      share(layout, component, instances);
    }
  }
  std::sort(layout.materials.begin(), layout.materials.end());
  layout.materials.erase(std::unique(layout.materials.begin(), layout.materials.end()), layout.materials.end());
  place_arrays(layout);
  return layout;
}

void measure_bounds(GltfLayout& layout, Progress& progress) {
  for (GltfMesh& mesh : layout.meshes) {
    for (GltfPrimitive& primitive : mesh.primitives) {
      for (const GltfPiece& piece : primitive.pieces) primitive.bounds.add(bounds_of(piece, progress));
    }
  }
}

}  // namespace meristem
