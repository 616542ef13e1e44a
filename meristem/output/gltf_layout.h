// SPDX-License-Identifier: Apache-2.0
// What a binary glTF will hold and where, decided before the first byte is written: which instances are baked into one
// mesh, which are nodes that share a mesh, and the place of every array in the binary chunk.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/progress.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// A mesh whose vertices are written once for every frame, moved by it.
struct GltfPiece {
  const Mesh* mesh = nullptr;
  std::span<const Frame> frames;

  std::uint64_t vertex_count() const { return mesh->vertex_count() * frames.size(); }
  std::uint64_t triangle_count() const { return mesh->triangle_count() * frames.size(); }
};

/// Where an array stands in the binary chunk; no bytes, no array.
struct GltfRange {
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
};

/// Pieces of one material with the same vertex attributes, as one primitive.
struct GltfPrimitive {
  std::uint32_t material = 0;  ///< index into MeshScene::materials
  bool has_normals = false;
  bool has_uvs = false;
  std::vector<GltfPiece> pieces;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  Box bounds;  ///< of all positions as they are written, exact
  GltfRange index_range, position_range, normal_range, uv_range;

  bool has_wide_indices() const { return vertices > 65535; }
};

struct GltfMesh {
  std::string name;
  std::vector<GltfPrimitive> primitives;
};

/// Instances that become nodes sharing `mesh`, but for those that is_expressible_as_node() refuses.
struct GltfSharedMesh {
  std::size_t mesh = 0;  ///< index into GltfLayout::meshes
  std::span<const Frame> frames;
};

/// One component of the document: a node of that name with what is baked, and one child a shared instance.
struct GltfComponent {
  static constexpr std::size_t kNoMesh = SIZE_MAX;
  std::string name;
  std::size_t baked_mesh = kNoMesh;  ///< index into GltfLayout::meshes
  std::vector<GltfSharedMesh> shared;
};

struct GltfLayout {
  std::vector<GltfMesh> meshes;
  std::vector<GltfComponent> components;
  std::vector<std::uint32_t> materials;  ///< indices into MeshScene::materials of those in use, rising
  std::uint64_t binary_bytes = 0;
  /// Frames of shared meshes that no node can express (sheared, or flat); they are baked.
  std::vector<std::vector<Frame>> inexpressible_frames;

  GltfLayout() = default;
  GltfLayout(const GltfLayout&) = delete;  // spans point into it
  GltfLayout(GltfLayout&&) = default;
};

/// Lays out everything but the bounds. All of `scene` is baked if it has at most `flatten_triangles` triangles, else
/// only meshes placed once. `scene` must outlive the result.
GltfLayout lay_out_gltf(const MeshScene& scene, std::uint64_t flatten_triangles);

/// Fills in the bounds of all primitives. Throws Cancelled.
void measure_bounds(GltfLayout& layout, Progress& progress);

/// True if a node's matrix may hold the frame: invertible, and made of translation, rotation and scale alone.
bool is_expressible_as_node(const Frame& frame);

}  // namespace meristem
