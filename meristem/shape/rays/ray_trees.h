// SPDX-License-Identifier: Apache-2.0
// The bounding volume trees in which Embree finds the hits of rays.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meristem/base/embree.h"
#include "meristem/base/progress.h"
#include "meristem/plant/material.h"
#include "meristem/shape/rays/ray_scene.h"
#include "meristem/shape/scene/mesh_scene.h"
#include "meristem/shape/texture/alpha_mask.h"

namespace meristem {

/// Finds the triangles of a mesh scene that rays hit.
///
/// The upper tree contains the geometries of parts that stand in the world once, and an instance for each place of a
/// placed plant. The tree of a placed plant contains the geometries of its parts. A geometry of a part is either all
/// triangles of all frames, or a list of instances. In a list, each frame is one box, and the ray continues in the tree
/// of the mesh, which exists once for each distinct mesh. In large scenes, one box holds several neighbouring frames,
/// or several neighbouring triangles of a part with one frame, and nothing is copied.
class RayTrees {
 public:
  /// `scene` must outlive this object. Parts with several frames are copied as triangles up to a total of
  /// `copied_triangles`, beginning with parts that stand in the world once. A scene is large if it has more than
  /// `large_from` distinct triangles and frames. Throws Cancelled, MachineError (memory).
  RayTrees(const MeshScene& scene, std::uint64_t copied_triangles, std::uint64_t large_from, Progress& progress);

  std::optional<RayHit> first_hit(const Ray& ray) const;
  bool is_blocked(const Ray& ray, float within) const;
  bool is_large() const { return is_large_; }  ///< true if the scene is large
  /// Returns the bytes that Embree uses now.
  std::uint64_t bytes() const;

 private:
  template <auto Release>
  struct Releaser {
    template <class Handle>
    void operator()(Handle* handle) const {
      Release(handle);
    }
  };
  using DeviceOwner = std::unique_ptr<RTCDeviceTy, Releaser<rtcReleaseDevice>>;
  using SceneOwner = std::unique_ptr<RTCSceneTy, Releaser<rtcReleaseScene>>;
  using GeometryOwner = std::unique_ptr<RTCGeometryTy, Releaser<rtcReleaseGeometry>>;

  /// The holes of a masked mesh. The uvs of each triangle are stored together, because a lookup through the mesh takes
  /// longer than all other steps of a hit.
  struct MaskedMesh {
    MaskedMesh(const Mesh& mesh, const AlphaMask& holes);
    const AlphaMask* mask;
    std::vector<std::array<Vec2, 3>> uvs;
  };
  /// A part as a list of instances, or as a list of triangles in packs.
  struct ListedPart {
    const MeshInstances* part = nullptr;
    RTCScene tree = nullptr;     ///< tree of its mesh; null for triangles
    Box box;                     ///< box of its mesh
    std::uint32_t in_a_box = 1;  ///< number of frames or triangles in one box

    Box bounds_of_frames(std::size_t begin) const;
    Box bounds_of_triangles(std::size_t begin) const;
  };
  struct HitContext;
  /// The part of a geometry.
  struct Geometry {
    std::uint32_t part = 0;
    bool is_instanced = false;
  };
  /// A plant that stands in several places.
  struct PlacedPlant {
    const std::vector<Frame>* places = nullptr;
    std::vector<Geometry> geometries;
    SceneOwner tree;
  };
  /// The object of a geometry of the upper tree: a part, or a plant in one of its places.
  struct TopGeometry {
    std::optional<Geometry> of_part;
    std::uint32_t plant = 0;
    std::uint32_t place = 0;
  };
  using LookKey = std::pair<const Mesh*, const Texture*>;

  static void pass_through_holes(const RTCFilterFunctionNArguments* arguments);
  static void find_bounds(const RTCBoundsFunctionArguments* arguments);
  static void meet_instance(const RTCIntersectFunctionNArguments* arguments);
  static void block_by_instance(const RTCOccludedFunctionNArguments* arguments);
  static void meet_triangle(const RTCIntersectFunctionNArguments* arguments);
  static void block_by_triangle(const RTCOccludedFunctionNArguments* arguments);

  SceneOwner new_scene(Progress& progress) const;
  void commit(const SceneOwner& scene, Progress& progress) const;
  PlacedPlant& plant_at(const std::vector<Frame>* places, Progress& progress);
  Geometry add_part(RTCScene scene, std::uint32_t number, bool is_copied, Progress& progress);
  void add_triangles(RTCScene scene, const Mesh& mesh, const std::vector<Frame>& frames, const Texture* texture,
                     Progress& progress);
  void add_instances(RTCScene scene, const MeshInstances& part, const Texture* texture, Progress& progress);
  void add_packed_triangles(RTCScene scene, const MeshInstances& part);
  /// Returns a geometry whose primitives are the boxes of a list of `count` items.
  GeometryOwner list_geometry(ListedPart& list, std::size_t count) const;
  RTCScene tree_of(const Mesh& mesh, const Texture* texture, Progress& progress);
  void cut_holes(RTCGeometry geometry, const Mesh& mesh, const Texture& texture);
  void add_places(Progress& progress);

  const MeshScene& scene_;
  mutable std::atomic<std::int64_t> bytes_{0};
  mutable std::string failure_;
  DeviceOwner device_;
  bool is_large_ = false;
  std::map<const Texture*, AlphaMask> masks_;
  std::map<LookKey, MaskedMesh> masked_meshes_;  ///< geometries point to them
  std::map<LookKey, SceneOwner> mesh_trees_;
  std::deque<ListedPart> listed_parts_;  ///< geometries point to them
  std::vector<PlacedPlant> plants_;
  std::unordered_map<const std::vector<Frame>*, std::size_t> plant_of_places_;
  std::vector<TopGeometry> geometries_;  ///< geometries of the upper tree
  SceneOwner top_;
};

}  // namespace meristem
