// SPDX-License-Identifier: Apache-2.0
// Whole plants that stand in several places: each grown once, of a document of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/material.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// One plant that others show as a whole: what a document has grown with some values and one seed.
struct PlantVariant {
  std::shared_ptr<const Plant> plant;
  std::uint64_t key = 0;  ///< hash of all that it was grown of: equal keys, equal plants
  /// Replaces the sketches of the plant's own textures in `materials`, which begin with the plant's, by pictures.
  std::function<void(std::vector<Material>& materials, Progress& progress, Cache* cache)> paint;
  std::shared_ptr<const std::vector<Material>> painted{};  ///< what that has made of the plant's materials; or null

  /// The plant's materials, with pictures where they have been painted.
  const std::vector<Material>& materials() const;
  std::uint64_t bytes() const;
};

/// What a plant has with all of its plantings' places.
struct PlantTotals {
  std::uint64_t stems = 0;
  std::uint64_t nodes = 0;
  std::uint64_t organs = 0;
};
PlantTotals totals_of(const Plant& plant);

/// Whether a plant has plantings; if not, it is its own expansion.
bool has_plantings(const Plant& plant);

/// The plant with a copy of each variant's stems and organs at each of its sites, and no plantings: what tables and
/// measures read. A component within a variant is called by both ids, as in "oak.leaf", and its instances are numbered
/// on from place to place. Throws InputError where the copies pass the limits on nodes or instances, before they are
/// made, and Cancelled.
Plant expanded(const Plant& plant, const Limits& limits, const Progress& progress);

/// Whether a plant has plantings that are deformed, each place in its own way.
bool has_deformed_plantings(const Plant& plant);
/// The plant with copies at the sites of those plantings alone; the others stay plantings.
Plant with_deformed_copies(const Plant& plant, const Limits& limits, const Progress& progress);

/// The plant itself, or its expansion where it has plantings.
class ExpandedPlant {
 public:
  /// `plant` must outlive this object, unless `plant` has plantings. `limits` are those of the document that the plant
  /// has grown from. Throws as expanded().
  ExpandedPlant(const Plant& plant, const Limits& limits, const Progress& progress);
  const Plant& operator*() const { return *plant_; }
  const Plant* operator->() const { return plant_; }

 private:
  std::shared_ptr<const Plant> made_;
  const Plant* plant_;
};

}  // namespace meristem
