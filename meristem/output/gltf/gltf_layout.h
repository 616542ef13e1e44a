// SPDX-License-Identifier: Apache-2.0
// Decides the content of a binary glTF before the first byte is written: which instances are baked into one mesh, which
// are nodes or instances that share a mesh, how colours are split into factors, and the position of every array and
// picture in the binary chunk.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/image.h"
#include "meristem/base/progress.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/write/colour_factors.h"
#include "meristem/shape/moving/moving_scene.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// A mesh whose vertices are written once for every frame, transformed by the frame.
struct GltfPiece {
  const Mesh* mesh = nullptr;
  std::span<const Frame> frames;
  std::span<const Vec3> tints;             ///< one per frame; empty if all are 1
  std::span<const std::uint32_t> members;  ///< the frames that belong to the piece; empty: all frames
  Vec3 origin{0};                          ///< origin of the node for which the piece is written
  const MeshMotion* motion = nullptr;      ///< null if the piece does not move

  std::size_t count() const { return members.empty() ? frames.size() : members.size(); }
  std::uint64_t vertex_count() const { return mesh->vertex_count() * count(); }
  std::uint64_t triangle_count() const { return mesh->triangle_count() * count(); }
  /// Returns the frame of the k-th instance, relative to the node.
  Frame frame(std::size_t k) const {
    const Frame& place = frames[member(k)];
    return {place.axes, place.origin - origin};
  }
  Vec3 tint(std::size_t k) const { return tints.empty() ? Vec3(1) : tints[member(k)]; }
  /// Returns the piece as it is at a key of its motion.
  GltfPiece at(std::size_t key) const;

 private:
  std::size_t member(std::size_t k) const { return members.empty() ? k : members[k]; }
};

/// The range of an array in the binary chunk. An array without bytes is not written.
struct GltfRange {
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
};

/// The arrays of a primitive's vertices, besides positions.
struct GltfAttributes {
  bool normals = false;
  bool uvs = false;
  bool tangents = false;
  bool colours = false;  ///< tints of instances, as factors on the colour of the material

  bool operator==(const GltfAttributes&) const = default;
};

/// The differences of a primitive's vertices at a key from their present state.
struct GltfTarget {
  Box bounds;  ///< bounds of the written differences of positions
  GltfRange position_range, normal_range, colour_range;
};

/// Pieces of one material with equal vertex attributes, written as one primitive.
struct GltfPrimitive {
  std::size_t material = 0;  ///< index into GltfLayout::materials
  GltfAttributes has;
  std::vector<GltfPiece> pieces;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  Box bounds;  ///< exact bounds of all positions as they are written
  GltfRange index_range, position_range, normal_range, uv_range, tangent_range, colour_range;
  std::vector<GltfTarget> targets;  ///< for each key except the last, if the primitive moves
  bool turns = false;               ///< true if targets have normals
  bool changes_colour = false;      ///< true if targets have colours

  bool has_wide_indices() const { return vertices > 65535; }
};

struct GltfMesh {
  std::string name;
  bool moves = false;  ///< true if its primitives have targets
  std::vector<GltfPrimitive> primitives;
};

/// Instances that share `mesh`, as nodes or as rows of arrays.
struct GltfSharedMesh {
  std::size_t mesh = 0;  ///< index into GltfLayout::meshes
  const MeshInstances* source = nullptr;
  std::vector<std::uint32_t> instances;  ///< indices of the source's instances, ascending
  bool is_mirrored = false;              ///< true if the mesh is mirrored in x, so that no row needs to mirror it
  Vec3 origin{0};                        ///< origin of the node for which the instances are written
  GltfRange translation_range, rotation_range, scale_range, colour_range;  ///< ranges of the arrays if instances are
                                                                           ///< rows
  const MeshMotion* motion = nullptr;  ///< motion of the nodes; null if they do not move

  /// Returns the transform of one of `instances`, for the shared mesh and relative to the node.
  Frame frame(std::size_t row) const;
};

/// A mesh that changes, with a node of its own.
struct GltfMovingMesh {
  static constexpr std::size_t kAlways = SIZE_MAX;
  std::size_t mesh = 0;            ///< index into GltfLayout::meshes
  std::size_t shown_at = kAlways;  ///< key from which the mesh is visible, until the next key
};

/// One of several plants: a node at its foot, with a child per component.
struct GltfPlant {
  std::string name;
  Vec3 foot{0};
};

/// One component of the document or of one of its plants. Its node has the baked mesh, and children for instances that
/// share a mesh.
struct GltfComponent {
  static constexpr std::size_t kNoMesh = SIZE_MAX;
  static constexpr std::size_t kNoPlant = SIZE_MAX;
  std::string name;
  std::size_t plant = kNoPlant;      ///< index into GltfLayout::plants
  std::size_t baked_mesh = kNoMesh;  ///< index into GltfLayout::meshes
  std::vector<GltfSharedMesh> shared;
  std::vector<GltfMovingMesh> moving;
};

/// A plant that stands in several places. Each place has a node with children for the plant's components. All places
/// share the meshes and arrays of the components.
struct GltfPlacedPlant {
  std::string name;
  const std::vector<Frame>* places = nullptr;
  std::size_t first_component = 0, end_component = 0;  ///< range in GltfLayout::components
};

/// A material of the scene, for one of the colours of its instances.
struct GltfMaterial {
  std::string name;
  std::uint32_t source = 0;          ///< index into MeshScene::materials
  const Texture* texture = nullptr;  ///< also null if its meshes have no uvs
  Vec3 base{1};                      ///< factor on the texture, linear, at most 1
  Vec3 transmitted{1};               ///< factor for light that passes through
};

struct GltfImage {
  std::string name;
  std::shared_ptr<const std::string> png;  ///< content of the PNG file
  GltfRange range;
};

/// A texture of the scene, as indices into GltfLayout::images.
struct GltfTexture {
  static constexpr std::size_t kNoImage = SIZE_MAX;
  const Texture* source = nullptr;
  std::size_t colour = kNoImage;
  std::size_t normals = kNoImage;
};

/// A property of a node over time, with a row of `data` per key.
struct GltfTrack {
  enum class Property { translation, rotation, scale, weights };
  Property property = Property::scale;
  std::size_t first = 0;    ///< index into GltfAnimation::data
  std::size_t numbers = 0;  ///< number of values of all keys together
  bool is_stepped = false;
};

/// The motion of nodes. Moving nodes are counted in the order in which nodes are written.
struct GltfAnimation {
  std::vector<float> data;  ///< the times of the keys, then the tracks
  std::size_t keys = 0;
  std::vector<std::vector<GltfTrack>> tracks;  ///< for each moving node
  GltfRange range;                             ///< range of `data` in the file
};

struct GltfLayout {
  std::vector<GltfMesh> meshes;
  std::vector<GltfPlant> plants;          ///< empty if plants have no nodes
  std::vector<GltfComponent> components;  ///< components in this order: of each plant together, in the order of plants;
                                          ///< the other components; components of placed plants
  std::size_t own_components = 0;         ///< number of components before the components of placed plants
  std::vector<GltfPlacedPlant> placed;
  std::vector<GltfMaterial> materials;  ///< materials in use
  std::vector<GltfTexture> textures;    ///< textures of `materials`; materials with equal Texture share one
  std::vector<GltfImage> images;
  std::vector<ColourFactors> factors;  ///< for each of MeshScene::materials
  bool has_instance_rows = false;      ///< true if instances are rows of arrays instead of nodes
  std::uint64_t binary_bytes = 0;
  std::vector<std::vector<std::uint32_t>> members;  ///< member lists of pieces with only some instances of a mesh
  GltfAnimation animation;                          ///< has no keys if nothing moves

  GltfLayout() = default;
  GltfLayout(const GltfLayout&) = delete;  // spans point into it
  GltfLayout(GltfLayout&&) = default;
};

/// Maximum number of plants with nodes of their own. Each plant takes several arrays, which readers keep separate.
inline constexpr std::size_t kMaxGltfPlants = 1000;
/// Maximum number of plants with nodes of their own if leaves are instances. Each plant then repeats a node and its
/// accessors per shared mesh, some 10 kB.
inline constexpr std::size_t kMaxInstancedGltfPlants = 100;

/// Lays out everything except the bounds, and encodes the pictures. The whole scene is baked if it has at most
/// `flatten_triangles` triangles and instances need not be rows. Otherwise only meshes with a single instance are
/// baked. `scene` must outlive the result. Throws Cancelled.
GltfLayout lay_out_gltf(const MeshScene& scene, const GltfOptions& options, Progress& progress);

/// Lays out a moving scene, like the function above.
GltfLayout lay_out_gltf(const MovingScene& moving, const GltfOptions& options, Progress& progress);

/// Computes the bounds of all primitives. Throws Cancelled.
void measure_bounds(GltfLayout& layout, Progress& progress);

/// Returns true if a node can have the frame as its matrix: the frame must be invertible and consist only of
/// translation, rotation and scale.
bool is_expressible_as_node(const Frame& frame);

}  // namespace meristem
