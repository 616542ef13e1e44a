// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/lofts.h"
#include "meristem/plant/deform_plant.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Puts a plant together from the results of its batches, and deforms it. Batches know no deformations: everything
/// grows and is placed in undeformed space.
class PlantAssembly {
 public:
  /// `graph` must outlive this object.
  explicit PlantAssembly(const Graph& graph) : graph_(graph), batches_of_(graph.components.size()) {}

  /// Adds the next batch, with instances of `component`. `own` is the batch if nobody else reads it, else null. `run`
  /// moves the organs out of own batches, so that no organ is in memory twice.
  void add(ComponentIndex component, std::shared_ptr<const BatchResult> batch, BatchResult* own);

  /// Returns the plant. Materials have sketches of their textures, and equal textures are shared. Prototypes and organs
  /// are ordered by component, then by batch; surfaces follow. Joined stems follow the order of the batches.
  /// Individuals follow the order in which batches found them. `mesh_bytes` is the size of the batches' meshes. Throws
  /// InputError if textures have too many pixels, if surfaces or deformed shapes take too many bytes, if trimming has
  /// left no stem, and as Deformation::map does. Throws Cancelled.
  Plant run(std::uint64_t mesh_bytes, Progress& progress);

 private:
  struct Made {
    ComponentIndex component = 0;
    std::shared_ptr<const BatchResult> result;
    BatchResult* own = nullptr;
  };

  using Surfaces = std::vector<SurfacePiece>;
  using Rows = std::vector<DeformedOrgans>;

  /// The individual plants of the document, and their numbers by the ids in sites.
  struct Individuals {
    std::vector<Individual> list;
    std::unordered_map<std::uint64_t, std::uint32_t> number_by_id;

    std::uint32_t number(std::uint64_t id) const;
  };

  void require_stems_left() const;
  bool has_prototypes(ComponentIndex component, bool blades) const;
  bool has_visible_stems(ComponentIndex component) const;
  std::uint64_t organ_count() const;
  Individuals find_individuals() const;
  std::vector<Surfaces> join_surfaces(const Individuals& individuals, std::uint64_t mesh_bytes,
                                      Progress& progress) const;
  std::uint32_t add_materials(ComponentIndex component, const Surfaces& surfaces, Plant& plant) const;
  void add_organs(ComponentIndex component, std::uint32_t material, const Individuals& individuals, Plant& plant,
                  Rows& deformed);
  void add_surfaces(ComponentIndex component, std::uint32_t material, const Surfaces& surfaces, Plant& plant,
                    Rows& deformed) const;
  void turn_sections(std::vector<SurfaceSection>& sections) const;
  static void deform(Plant& plant, const Rows& organs, std::uint64_t mesh_bytes, const SizeLimits& limits,
                     Progress& progress);
  std::vector<Stem> joined_stems(const std::vector<std::uint32_t>& material_of_component,
                                 const Individuals& individuals);

  const Graph& graph_;
  std::vector<Made> batches_;
  std::vector<std::vector<std::size_t>> batches_of_;  // by component: indices of batches
};

}  // namespace meristem
