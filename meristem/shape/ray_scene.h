// SPDX-License-Identifier: Apache-2.0
// Finds what rays meet in a mesh scene: the first surface, or whether any surface lies in the way. Wraps Embree.
// Instances of small scenes are copied into one tree of triangles. Instances of larger scenes stay instances. Rays pass
// through the holes of masked textures.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/shape/mesh_scene.h"

namespace meristem {

/// A way through the scene, and how wide a beam it stands for.
struct Ray {
  Vec3 origin;       ///< metres, world space
  Vec3 direction;    ///< unit
  float spread = 0;  ///< by how much it stands for a wider cone, metres per metre; raised, textures are blurred more
};

/// A position on a surface.
struct RayHit {
  float distance = 0;          ///< metres along the ray
  std::uint32_t part = 0;      ///< index into MeshScene::meshes
  std::uint32_t instance = 0;  ///< number among the mesh's instances
  std::uint32_t triangle = 0;  ///< index into its mesh's triangles
  Vec2 barycentric{0};         ///< weights of the triangle's second and third vertex
};

/// The surface where a ray meets it, in world space.
struct SurfacePoint {
  Vec3 position;       ///< metres, on the triangle
  Vec3 face_normal;    ///< unit, of the triangle's front
  Vec3 normal;         ///< unit, interpolated where the mesh has normals
  Vec3 smooth_offset;  ///< from `position` to the curved surface that the interpolated normals suggest
};

/// How a texture lies on the surface where a ray meets it, in world space.
struct TextureMapping {
  Vec2 uv{0};               ///< texture coordinates
  Vec3 along_u{0};          ///< unit where the mesh has tangents or its uvs spread, else 0
  Vec3 along_v{0};          ///< unit where the mesh has tangents or its uvs spread, else 0
  float uvs_per_metre = 0;  ///< geometric mean of both ways
};

class RayTrees;

/// How a scene of rays spends memory.
struct RaySceneOptions {
  /// Parts with several frames are copied out, 100 bytes for each triangle, while their triangles are at most this
  /// number in all, and those of placed plants while they are at most a third of it; parts without places come first.
  std::uint64_t copied_triangles = 3'000'000;
  /// A scene with more distinct triangles and frames than this number is large: it copies nothing, takes less memory
  /// for all of them, and rays take up to twice the time.
  std::uint64_t large_from = 10'000'000;
};

/// All triangles of a mesh scene, to be met by rays.
class RayScene {
 public:
  /// `scene` must outlive this. Memory: about 100 bytes for each triangle of a distinct mesh, and about 85 bytes for
  /// each instance of a mesh with several frames; in large scenes, 10 bytes for each distinct triangle and 20 bytes for
  /// each instance. The frames of a placed plant count once, whatever the number of its places. Throws Cancelled,
  /// MachineError (memory).
  RayScene(const MeshScene& scene, Progress& progress, const RaySceneOptions& options = {});
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// The first surface along the ray. May be called from many threads.
  std::optional<RayHit> first_hit(const Ray& ray) const;
  /// Whether any surface lies on the ray, `within` metres.
  bool is_blocked(const Ray& ray, float within = std::numeric_limits<float>::infinity()) const;
  /// How far off a surface at a position a ray has to start not to meet it again, metres.
  static float clearance(Vec3 point);
  /// Returns the bytes of the trees, without the memory of `scene` itself.
  std::uint64_t bytes() const;
  /// Returns the surface at a hit.
  SurfacePoint surface_point(const RayHit& hit) const;
  /// Normal of the triangle's front, unit, in world space; faster than surface_point.
  Vec3 face_normal(const RayHit& hit) const;
  /// Returns how the texture lies on the surface at a hit.
  TextureMapping texture_mapping(const RayHit& hit) const;
  /// Linear factors on the colour of the instance that was hit.
  Vec3 tint(const RayHit& hit) const { return scene_.meshes[hit.part].tint(hit.instance); }

 private:
  const MeshScene& scene_;
  std::unique_ptr<const RayTrees> trees_;
};

}  // namespace meristem
