// SPDX-License-Identifier: Apache-2.0
// Finds the hits of rays in a mesh scene: the first surface, or whether any surface blocks the ray. Wraps Embree.
// Instances of small scenes are copied into one tree of triangles, and instances of larger scenes stay instances. Rays
// pass through the holes of masked textures.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// A ray through the scene, and the width of the beam that it represents.
struct Ray {
  Vec3 origin;       ///< metres, world space
  Vec3 direction;    ///< unit
  float spread = 0;  ///< growth of the beam's width, metres per metre; larger values blur textures more
};

/// A position on a surface.
struct RayHit {
  float distance = 0;          ///< metres along the ray
  std::uint32_t part = 0;      ///< index into MeshScene::meshes
  std::uint32_t instance = 0;  ///< number among the mesh's instances
  std::uint32_t triangle = 0;  ///< index into its mesh's triangles
  Vec2 barycentric{0};         ///< weights of the triangle's second and third vertex
};

/// The surface at a hit, in world space.
struct SurfacePoint {
  Vec3 position;       ///< metres, on the triangle
  Vec3 face_normal;    ///< unit normal of the triangle's front
  Vec3 normal;         ///< unit normal, interpolated if the mesh has normals
  Vec3 smooth_offset;  ///< from `position` to the curved surface that the interpolated normals suggest
};

/// The position and scale of a texture on the surface at a hit, in world space.
struct TextureMapping {
  Vec2 uv{0};               ///< texture coordinates
  Vec3 along_u{0};          ///< unit vector if the mesh has tangents or its uvs define it, otherwise 0
  Vec3 along_v{0};          ///< unit vector if the mesh has tangents or its uvs define it, otherwise 0
  float uvs_per_metre = 0;  ///< geometric mean of both directions
};

class RayTrees;

/// Options for the memory of a scene of rays.
struct RaySceneOptions {
  /// Maximum number of triangles that are copied. Parts with several frames are copied until their triangles reach this
  /// number, at 100 bytes per triangle. Parts of placed plants are copied up to a third of it. Parts without places
  /// come first.
  std::uint64_t copied_triangles = 3'000'000;
  /// A scene with more distinct triangles and frames than this is large. It copies nothing and takes less memory for
  /// all of them, but rays take up to twice the time.
  std::uint64_t large_from = 10'000'000;
};

/// The triangles of a mesh scene, prepared for rays.
class RayScene {
 public:
  /// `scene` must outlive this object. Memory: about 100 bytes for each triangle of a distinct mesh, and about 85 bytes
  /// for each instance of a mesh with several frames. In large scenes, it is 10 bytes for each distinct triangle and 20
  /// bytes for each instance. The frames of a placed plant count once, whatever the number of its places. Throws
  /// Cancelled, MachineError (memory).
  RayScene(const MeshScene& scene, Progress& progress, const RaySceneOptions& options = {});
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// Returns the first surface along the ray. May be called from many threads.
  std::optional<RayHit> first_hit(const Ray& ray) const;
  /// Returns true if any surface lies on the ray, up to `within` metres.
  bool is_blocked(const Ray& ray, float within = std::numeric_limits<float>::infinity()) const;
  /// Returns the minimum distance of a ray's start from a surface at `point`, so that the ray does not hit this surface
  /// again. Metres.
  static float clearance(Vec3 point);
  /// Returns the memory of the trees in bytes, without `scene` itself.
  std::uint64_t bytes() const;
  /// Returns the surface at a hit.
  SurfacePoint surface_point(const RayHit& hit) const;
  /// Returns the unit normal of the triangle's front in world space. Faster than surface_point.
  Vec3 face_normal(const RayHit& hit) const;
  /// Returns the position and scale of the texture on the surface at a hit.
  TextureMapping texture_mapping(const RayHit& hit) const;
  /// Returns the linear factors on the colour of the instance at a hit.
  Vec3 tint(const RayHit& hit) const { return scene_.meshes[hit.part].tint(hit.instance); }

 private:
  const MeshScene& scene_;
  std::unique_ptr<const RayTrees> trees_;
};

}  // namespace meristem
