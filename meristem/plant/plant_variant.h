// SPDX-License-Identifier: Apache-2.0
// Whole plants that stand in several places. Each is grown once, from its own document.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/function_ref.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/material.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// A plant that other documents place as a whole: the result of one document with certain values and one seed.
struct PlantVariant {
  std::shared_ptr<const Plant> plant;  ///< the grown plant
  std::uint64_t key = 0;               ///< hash of all inputs of the growth: equal keys mean equal plants
  /// Paints the plant's own textures: replaces their sketches in `materials` by pictures. The plant's materials come
  /// first in `materials`.
  std::function<void(std::vector<Material>& materials, Progress& progress, Cache* cache)> paint;
  std::shared_ptr<const std::vector<Material>> painted{};  ///< the painted materials; null until painted

  /// Returns the plant's materials, with pictures if they have been painted.
  const std::vector<Material>& materials() const;
  std::uint64_t bytes() const;  ///< estimated heap memory of its organs and skeletons
};

/// Numbers of stems, nodes and organs, with all places of plantings counted.
struct PlantTotals {
  std::uint64_t stems = 0;   ///< grown skeletons
  std::uint64_t nodes = 0;   ///< skeleton nodes
  std::uint64_t organs = 0;  ///< instances of prototypes
};
/// Counts a plant and its plantings, without copying them.
PlantTotals totals_of(const Plant& plant);

/// Returns true if the plant has plantings. A plant without plantings is its own expansion.
bool has_plantings(const Plant& plant);

/// Returns the plant with a copy of each variant's stems and organs at each of its places, and without plantings.
/// Tables and measures read this form. A component within a variant is named by both ids, such as "oak.leaf", and its
/// instances are numbered on from place to place. Throws InputError before copying if the copies exceed the limits of
/// nodes or instances. Throws Cancelled.
Plant expanded(const Plant& plant, const SizeLimits& limits, const Progress& progress);

/// Approximate number of nodes and organs in a block of expand_in_blocks(). Larger: more memory per block.
inline constexpr std::size_t kExpandedBlock = 1'000'000;

/// Calls `take` with the stems and organs of expanded() in their order, in blocks, and returns all individuals. The
/// first block is `plant` itself, which is not copied. A later block is a copy of one or several placed plants. It ends
/// after the plant that makes it reach `block_size` nodes and organs. Places of deformed plantings are not divided.
/// Materials, prototypes and individuals have the indices of expanded(); later blocks contain more of them. Memory: one
/// block, and all deformed geometry. Throws what expanded() and `take` throw.
std::vector<Individual> expand_in_blocks(const Plant& plant, const SizeLimits& limits, const Progress& progress,
                                         FunctionRef<void(const Plant& block)> take,
                                         std::size_t block_size = kExpandedBlock);

/// Returns true if the plant has plantings whose places are deformed, each in its own way.
bool has_deformed_plantings(const Plant& plant);
/// Like expanded(), but copies only deformed plantings. The others stay plantings.
Plant with_deformed_copies(const Plant& plant, const SizeLimits& limits, const Progress& progress);

/// Access to a plant's expansion. Refers to the plant itself if it has no plantings.
class ExpandedPlant {
 public:
  /// `plant` must outlive this object unless it has plantings. `limits` must be the limits of the plant's document.
  /// Throws as expanded() does.
  ExpandedPlant(const Plant& plant, const SizeLimits& limits, const Progress& progress);
  /// The expanded plant.
  const Plant& operator*() const { return *plant_; }
  const Plant* operator->() const { return plant_; }  ///< access to members of the expanded plant

 private:
  std::shared_ptr<const Plant> made_;
  const Plant* plant_;
};

}  // namespace meristem
