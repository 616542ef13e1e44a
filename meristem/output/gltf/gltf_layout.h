// SPDX-License-Identifier: Apache-2.0
// What a binary glTF will hold and where, decided before the first byte is written: which instances are baked into one
// mesh, which are nodes or instances that share a mesh, how colours are split into factors, and the transform of every
// array and picture in the binary chunk.
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
#include "meristem/shape/mesh_scene.h"
#include "meristem/shape/moving/moving_scene.h"

namespace meristem {

/// A mesh whose vertices are written once for every frame, moved by it.
struct GltfPiece {
  const Mesh* mesh = nullptr;
  std::span<const Frame> frames;
  std::span<const Vec3> tints;             ///< one per frame; empty where all are 1
  std::span<const std::uint32_t> members;  ///< the frames that belong to it; empty: all
  Vec3 origin{0};                          ///< of the node that it is written for
  const MeshMotion* motion = nullptr;      ///< null: it does not move

  std::size_t count() const { return members.empty() ? frames.size() : members.size(); }
  std::uint64_t vertex_count() const { return mesh->vertex_count() * count(); }
  std::uint64_t triangle_count() const { return mesh->triangle_count() * count(); }
  /// The frame of its k-th instance, seen from the node.
  Frame frame(std::size_t k) const {
    const Frame& place = frames[member(k)];
    return {place.axes, place.origin - origin};
  }
  Vec3 tint(std::size_t k) const { return tints.empty() ? Vec3(1) : tints[member(k)]; }
  /// What it is at a key of its motion.
  GltfPiece at(std::size_t key) const;

 private:
  std::size_t member(std::size_t k) const { return members.empty() ? k : members[k]; }
};

/// Where an array stands in the binary chunk; no bytes, no array.
struct GltfRange {
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
};

/// Which arrays the vertices of a primitive have besides positions.
struct GltfAttributes {
  bool normals = false;
  bool uvs = false;
  bool tangents = false;
  bool colours = false;  ///< tints of instances, as factors on the material's colour

  bool operator==(const GltfAttributes&) const = default;
};

/// How the vertices of a primitive differ at a key from what they are.
struct GltfTarget {
  Box bounds;  ///< of the differences of positions as they are written
  GltfRange position_range, normal_range, colour_range;
};

/// Pieces of one material with the same vertex attributes, as one primitive.
struct GltfPrimitive {
  std::size_t material = 0;  ///< index into GltfLayout::materials
  GltfAttributes has;
  std::vector<GltfPiece> pieces;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  Box bounds;  ///< of all positions as they are written, exact
  GltfRange index_range, position_range, normal_range, uv_range, tangent_range, colour_range;
  std::vector<GltfTarget> targets;  ///< by key but the last, where it moves
  bool turns = false;               ///< targets have normals
  bool changes_colour = false;      ///< targets have colours

  bool has_wide_indices() const { return vertices > 65535; }
};

struct GltfMesh {
  std::string name;
  bool moves = false;  ///< its primitives have targets
  std::vector<GltfPrimitive> primitives;
};

/// Instances that share `mesh`: nodes of their own, or rows of arrays.
struct GltfSharedMesh {
  std::size_t mesh = 0;  ///< index into GltfLayout::meshes
  const MeshInstances* source = nullptr;
  std::vector<std::uint32_t> instances;  ///< of the source, rising
  bool is_mirrored = false;              ///< the mesh is its mirror image in x, so that no row has to mirror it
  Vec3 origin{0};                        ///< of the node that it is written for
  GltfRange translation_range, rotation_range, scale_range, colour_range;  ///< where instances are rows
  const MeshMotion* motion = nullptr;  ///< of nodes that move; null: they stand still

  /// The transform of one of `instances`, as the shared mesh needs it, seen from the node.
  Frame frame(std::size_t row) const;
};

/// A mesh that changes, in a node of its own.
struct GltfMovingMesh {
  static constexpr std::size_t kAlways = SIZE_MAX;
  std::size_t mesh = 0;            ///< index into GltfLayout::meshes
  std::size_t shown_at = kAlways;  ///< the key from which it is seen up to the next one
};

/// One of several plants: a node at its foot, and children for its components.
struct GltfPlant {
  std::string name;
  Vec3 foot{0};
};

/// One component of the document, or of one of its plants: a node of that name with what is baked, and children for
/// what shares a mesh.
struct GltfComponent {
  static constexpr std::size_t kNoMesh = SIZE_MAX;
  static constexpr std::size_t kNoPlant = SIZE_MAX;
  std::string name;
  std::size_t plant = kNoPlant;      ///< index into GltfLayout::plants
  std::size_t baked_mesh = kNoMesh;  ///< index into GltfLayout::meshes
  std::vector<GltfSharedMesh> shared;
  std::vector<GltfMovingMesh> moving;
};

/// A plant that stands in several places: a node in each, with children for its components, which share their meshes
/// and arrays among all places.
struct GltfPlacedPlant {
  std::string name;
  const std::vector<Frame>* places = nullptr;
  std::size_t first_component = 0, end_component = 0;  ///< of GltfLayout::components
};

/// A material of the scene, or one of the colours that its instances have.
struct GltfMaterial {
  std::string name;
  std::uint32_t source = 0;          ///< index into MeshScene::materials
  const Texture* texture = nullptr;  ///< null where its meshes have no uvs, too
  Vec3 base{1};                      ///< factor on the texture, linear, at most 1
  Vec3 transmitted{1};               ///< factor for light that passes through
};

struct GltfImage {
  std::string name;
  std::shared_ptr<const std::string> png;  ///< the bytes of the file
  GltfRange range;
};

/// A texture of the scene: indices into GltfLayout::images.
struct GltfTexture {
  static constexpr std::size_t kNoImage = SIZE_MAX;
  const Texture* source = nullptr;
  std::size_t colour = kNoImage;
  std::size_t normals = kNoImage;
};

/// What a property of a node is over time: a row of `data` per key.
struct GltfTrack {
  enum class Property { translation, rotation, scale, weights };
  Property property = Property::scale;
  std::size_t first = 0;    ///< of GltfAnimation::data
  std::size_t numbers = 0;  ///< of all keys
  bool is_stepped = false;
};

/// How nodes move. Those that do are counted in the order in which nodes are written.
struct GltfAnimation {
  std::vector<float> data;  ///< the times of the keys, and the tracks
  std::size_t keys = 0;
  std::vector<std::vector<GltfTrack>> tracks;  ///< by node that moves
  GltfRange range;                             ///< of the data
};

struct GltfLayout {
  std::vector<GltfMesh> meshes;
  std::vector<GltfPlant> plants;          ///< empty where plants have no nodes
  std::vector<GltfComponent> components;  ///< those of each plant together, in the order of plants, then the others,
                                          ///< and those of placed plants
  std::size_t own_components = 0;         ///< number of those that are of no placed plant
  std::vector<GltfPlacedPlant> placed;
  std::vector<GltfMaterial> materials;  ///< those in use
  std::vector<GltfTexture> textures;    ///< of those; materials with the same Texture share it
  std::vector<GltfImage> images;
  std::vector<ColourFactors> factors;  ///< of each of MeshScene::materials
  bool has_instance_rows = false;      ///< instances are rows of arrays, not nodes
  std::uint64_t binary_bytes = 0;
  std::vector<std::vector<std::uint32_t>> members;  ///< those of pieces that have some of a mesh's instances
  GltfAnimation animation;                          ///< without keys where nothing moves

  GltfLayout() = default;
  GltfLayout(const GltfLayout&) = delete;  // spans point into it
  GltfLayout(GltfLayout&&) = default;
};

/// More plants have no nodes of their own: each takes several arrays, which readers keep apart.
inline constexpr std::size_t kMostGltfPlants = 1000;
/// The most plants with nodes of their own where leaves are instances: each plant then repeats a node and its accessors
/// per shared mesh, some 10 kB.
inline constexpr std::size_t kMostInstancedGltfPlants = 100;

/// Lays out everything but the bounds, and makes the pictures' bytes. All of `scene` is baked if it has at most
/// `flatten_triangles` triangles and instances are not to be rows, else only meshes placed once. `scene` must outlive
/// the result. Throws Cancelled.
GltfLayout lay_out_gltf(const MeshScene& scene, const GltfOptions& options, Progress& progress);

/// The same for a scene that moves.
GltfLayout lay_out_gltf(const MovingScene& moving, const GltfOptions& options, Progress& progress);

/// Fills in the bounds of all primitives. Throws Cancelled.
void measure_bounds(GltfLayout& layout, Progress& progress);

/// True if a node's matrix may hold the frame: invertible, and made of translation, rotation and scale alone.
bool is_expressible_as_node(const Frame& frame);

}  // namespace meristem
