// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/frame.h"
#include "meristem/base/limits.h"
#include "meristem/base/mesh.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/detail.h"
#include "meristem/shape/mesh_origin.h"

namespace meristem {

/// One mesh, placed any number of times.
struct MeshInstances {
  std::string component;             ///< id in the document; exports group by it
  std::shared_ptr<const Mesh> mesh;  ///< not null
  std::uint32_t material = 0;        ///< index into MeshScene::materials
  std::vector<Frame> frames;         ///< one per instance; rotations, uneven scales and mirrors are allowed
  std::vector<Vec3> tints;           ///< linear factors on the material's colour, one per frame; empty where all are 1
  /// Index into MeshScene::individuals or kNoIndividual, one per frame; empty where all are of the first.
  std::vector<std::uint32_t> individuals{};
  /// Where the plant stands whose part this is, if it stands in several places: each frame is meant in each of them.
  /// All parts of the plant share the list. Null: in the world, once.
  std::shared_ptr<const std::vector<Frame>> places{};
  /// What of the plant it shows; null where that is not known, as in coarser levels of small plants and in obstacles.
  std::shared_ptr<const MeshOrigin> origin{};

  /// Returns the number of places of the plant that the part belongs to.
  std::size_t place_count() const { return places == nullptr ? 1 : places->size(); }
  /// Instances in all, place by place.
  std::size_t count() const { return frames.size() * place_count(); }
  /// Returns the frame of an instance in the world.
  Frame frame(std::size_t instance) const {
    return places == nullptr ? frames[instance]
                             : (*places)[instance / frames.size()] * frames[instance % frames.size()];
  }
  std::uint64_t triangle_count() const { return mesh->triangle_count() * count(); }  ///< triangles of all instances
  /// Returns the tint of an instance.
  Vec3 tint(std::size_t instance) const { return tints.empty() ? Vec3(1) : tints[instance % frames.size()]; }
  /// The plant that an instance belongs to.
  std::uint32_t individual(std::size_t instance) const { return individuals.empty() ? 0 : individuals[instance]; }
};

/// Meshes, materials and instances of them. Everything that leaves the program is written from it.
struct MeshScene {
  std::vector<Material> materials;  ///< materials of all meshes
  /// The meshes of one component stand together, components in the order in which the plant first names them (stems
  /// before prototypes), their stems and prototypes in the plant's order. No mesh is without triangles or frames.
  std::vector<MeshInstances> meshes;
  std::vector<Individual> individuals;  ///< the plant's; empty: all is one

  std::uint64_t triangle_count() const;  ///< after instancing
  std::uint64_t instance_count() const;  ///< instances of all meshes, in all places
  /// The smallest box around all vertices of all instances.
  Box bounds() const;
};

/// Clothes a plant: every stem gets its surface (blended bodies and crowns: body_meshes.h), every prototype its
/// instances (in the order of the plant's organs); how coarsely, `detail` says (detail.h). With a `cache`, stems that
/// it has clothed before keep their meshes (cached_meshes.h). Begins a stage of `progress`, which counts nodes and
/// organs, and before it those of bodies. Throws InputError where the limits on triangles or geometry would be passed,
/// before memory is spent: it names the component that has most. Throws Cancelled, and std::invalid_argument for
/// indices that point nowhere and details out of range.
MeshScene make_mesh_scene(const Plant& plant, const Limits& limits, Progress& progress, const Detail& detail = {},
                          Cache* cache = nullptr);

/// Makes the same meshes, and frees the plant while it makes them: first its own stems and organs, then each variant
/// that nobody else holds. So stands of many different plants take less memory.
MeshScene make_mesh_scene(Plant&& plant, const Limits& limits, Progress& progress, const Detail& detail = {});

}  // namespace meristem
