// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/scene/mesh_origin.h"

namespace meristem {

/// One mesh, placed any number of times.
struct MeshInstances {
  std::string component;             ///< id in the document; exports group by it
  std::shared_ptr<const Mesh> mesh;  ///< not null
  std::uint32_t material = 0;        ///< index into MeshScene::materials
  std::vector<Frame> frames;         ///< one per instance; rotations, uneven scales and mirrors are allowed
  std::vector<Vec3> tints;           ///< linear factors on the material's colour, one per frame; empty if all are 1
  /// Index into MeshScene::individuals or kNoIndividual, one per frame. Empty if all frames belong to the first
  /// individual.
  std::vector<std::uint32_t> individuals{};
  /// Places of the plant that has this part, if it stands in several places. Each frame is repeated at each of them.
  /// All parts of the plant share the list. Null: once in the world.
  std::shared_ptr<const std::vector<Frame>> places{};
  /// The part of the plant that the mesh shows. Null if it is unknown, as in coarser levels of small plants and in
  /// obstacles.
  std::shared_ptr<const MeshOrigin> origin{};
  bool is_crown = false;  ///< true: a crown body, which is an object of its own in files

  /// Returns the number of places of the plant that has the part.
  std::size_t place_count() const { return places == nullptr ? 1 : places->size(); }
  /// Returns the number of all instances, place by place.
  std::size_t count() const { return frames.size() * place_count(); }
  /// Returns the frame of an instance in the world.
  Frame frame(std::size_t instance) const {
    return places == nullptr ? frames[instance]
                             : (*places)[instance / frames.size()] * frames[instance % frames.size()];
  }
  std::uint64_t triangle_count() const { return mesh->triangle_count() * count(); }  ///< triangles of all instances
  /// Returns the tint of an instance.
  Vec3 tint(std::size_t instance) const { return tints.empty() ? Vec3(1) : tints[instance % frames.size()]; }
  /// Returns the individual of an instance.
  std::uint32_t individual(std::size_t instance) const { return individuals.empty() ? 0 : individuals[instance]; }
};

/// Returns the name of the mesh's object in files: the component, with "_crown" for crown bodies.
std::string object_name(const MeshInstances& instances);

/// Meshes, materials and instances. All exports are written from a mesh scene.
struct MeshScene {
  std::vector<Material> materials;  ///< materials of all meshes
  /// The meshes of one component stand together. Components are in the order of their first occurrence in the plant
  /// (stems before prototypes), and their stems and prototypes in the plant's order. Every mesh has triangles and
  /// frames.
  std::vector<MeshInstances> meshes;
  std::vector<Individual> individuals;  ///< individuals of the plant; empty: the whole plant is one

  std::uint64_t triangle_count() const;  ///< counted after instancing
  std::uint64_t instance_count() const;  ///< instances of all meshes, in all places
  /// Returns the smallest box around all vertices of all instances.
  Box bounds() const;
};

}  // namespace meristem
