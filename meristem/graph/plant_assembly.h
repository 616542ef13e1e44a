// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/graph.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Puts a plant together from what its batches have made.
class PlantAssembly {
 public:
  /// `graph` outlives it.
  explicit PlantAssembly(const Graph& graph) : graph_(graph), batches_of_(graph.components.size()) {}

  /// The next batch, of instances of `component`.
  void add(ComponentIndex component, std::shared_ptr<const BatchResult> batch);

  /// The plant: materials, prototypes and organs in the order of the components, those of one component in the order of
  /// its batches; stems in the order of the batches, joined. Throws InputError where the textures have too many pixels,
  /// Cancelled.
  Plant run(Progress& progress) const;

 private:
  struct Made {
    ComponentIndex component = 0;
    std::shared_ptr<const BatchResult> result;
  };

  std::uint32_t add_materials(ComponentIndex component, Plant& plant) const;
  void add_organs(ComponentIndex component, std::uint32_t material, Plant& plant) const;
  std::vector<Stem> joined_stems(const std::vector<std::uint32_t>& material_of_component) const;
  void check_pixels(const std::vector<Material>& materials) const;

  const Graph& graph_;
  std::vector<Made> batches_;
  std::vector<std::vector<const BatchResult*>> batches_of_;  // by component
};

}  // namespace meristem
