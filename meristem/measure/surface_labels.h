// SPDX-License-Identifier: Apache-2.0
// Finds the tree, component, instance and shoot to which a position on a plant's surface belongs.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/measure/measures.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/scene/mesh_scene.h"

namespace meristem {

/// The kind of object to which a surface belongs.
enum class SurfaceKind : std::uint8_t {
  ground,
  wood,      ///< the surface of a stem, or of a body or crown around it
  organ,     ///< a leaf, a flower, a fruit or other geometry that stands on stems
  obstacle,  ///< a body of the scene
};
/// Names of the kinds in files and arrays, in the order of SurfaceKind.
inline constexpr std::array<std::string_view, 4> kSurfaceKindNames{"ground", "wood", "organ", "obstacle"};

/// Marks a position that belongs to no shoot.
inline constexpr std::uint32_t kNoShoot = 0xffffffffU;

/// The origin of a position on a surface.
struct SurfaceLabel {
  SurfaceKind kind = SurfaceKind::ground;  ///< ground, wood, organ or obstacle
  std::uint32_t component = 0;             ///< index into SurfaceLabels::components
  std::uint32_t instance = 0;              ///< number of the stem or organ within its component, from 0
  std::uint32_t tree = kNoTree;            ///< number of the tree, or kNoTree
  std::uint32_t shoot = kNoShoot;          ///< number of the shoot, or kNoShoot
  std::uint16_t order = 0;                 ///< branching order of the shoot

  bool operator==(const SurfaceLabel&) const = default;
};

/// The origin of a shoot.
struct ShootOrigin {
  std::string component;    ///< id of the component that has grown the shoot, such as "oak.tree" in a placed plant
  std::uint16_t order = 0;  ///< branching order
};

struct LabelFacts;

/// The labels of a plant, before its meshes exist.
class PlantLabels {
 public:
  /// `plant` may be freed afterwards. Begins a stage of `progress`, which counts organs. Throws InputError if `limits`
  /// are exceeded, Cancelled.
  PlantLabels(const Plant& plant, const SizeLimits& limits, Progress& progress);
  PlantLabels(PlantLabels&&) noexcept;
  ~PlantLabels();

 private:
  friend class SurfaceLabels;
  std::unique_ptr<LabelFacts> facts_;
};

/// The labels of all surfaces of a mesh scene.
///
/// Numbers agree with the tables of skeletons and organs. A shoot is an `axis` of SkeletonTable. A tree is a root of a
/// stem, as measure_plant counts them. An instance is an instance of a stem's part, or an instance of organ_instances.
/// A triangle of a tube belongs to the axis of the tube. A triangle of a blended body or crown belongs to the axis
/// whose surface is nearest (segment_tree.h). An organ belongs to the shoot whose surface is nearest to the point of
/// attachment.
class SurfaceLabels {
 public:
  /// `scene` must be the result of make_mesh_scene for `plant` at level 0, with or without obstacles (with_obstacles).
  /// `scene` must outlive this object, but `plant` may be freed. Begins a stage of `progress`, which counts organs.
  /// Throws InputError if `limits` are exceeded, Cancelled.
  SurfaceLabels(const Plant& plant, const SizeLimits& limits, const MeshScene& scene, Progress& progress);
  /// Like the constructor above, with labels that were read from the plant before. `scene` can also be the result of
  /// make_ray_meshes.
  SurfaceLabels(PlantLabels&& labels, const MeshScene& scene);
  ~SurfaceLabels();
  SurfaceLabels(const SurfaceLabels&) = delete;
  SurfaceLabels& operator=(const SurfaceLabels&) = delete;

  /// Returns the label of a triangle of an instance of a part (MeshScene::meshes), near a world position on the
  /// triangle. May be called from many threads.
  SurfaceLabel of(std::uint32_t part, std::uint32_t instance, std::uint32_t triangle, Vec3 position) const;

  /// Returns the ids of the components in the order in which the scene has their meshes, and last "ground".
  const std::vector<std::string>& components() const;
  /// Returns the index of "ground" among the components.
  std::uint32_t ground() const { return static_cast<std::uint32_t>(components().size()) - 1; }
  /// Returns the number of all shoots of the plant.
  std::uint32_t shoot_count() const;
  /// Returns the label (axis_labels.h) of a shoot. May be called from many threads.
  const std::string& shoot_label(std::uint32_t shoot) const;
  /// Returns the origin of a shoot. May be called from many threads.
  ShootOrigin shoot_origin(std::uint32_t shoot) const;

 private:
  std::unique_ptr<const LabelFacts> facts_;
};

}  // namespace meristem
