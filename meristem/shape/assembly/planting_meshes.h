// SPDX-License-Identifier: Apache-2.0
// The meshes of whole plants that stand in several places.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "meristem/base/cache.h"
#include "meristem/base/fingerprint.h"
#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/plant/planting.h"
#include "meristem/shape/scene/mesh_scene.h"
#include "meristem/shape/stem/cached_meshes.h"

namespace meristem {

/// Options and functions to make the meshes of placed plants.
struct PlantingRecipe {
  /// Makes the meshes of a variant, and may free the variant. Called on several threads at once.
  std::function<VariantMeshes(std::shared_ptr<const PlantVariant> variant, Progress& progress)> make;
  /// Adds everything that the result of `make` depends on besides the variant.
  std::function<void(const PlantVariant& variant, Fingerprint& key)> add_key;
  /// Returns the share of a variant's places that are shown, above 0, if its meshes have `made` triangles. Null: all
  /// are shown.
  std::function<double(const PlantVariant& variant, std::uint64_t made)> shown_places{};
};

/// Adds the meshes of a plant's plantings to `scene`. Each variant's meshes are made once. They are cached as soon as
/// they are made, so a cancelled call leaves them for the next call. A variant without other owners is freed after its
/// meshes were made, unless `shown_places` needs it. Returns true if all places of all plantings are shown with whole
/// meshes. Throws InputError if limits would be exceeded. If several variants fail, the first error is thrown. Throws
/// Cancelled.
bool add_plantings(MeshScene& scene, std::vector<Planting> plantings, const PlantingRecipe& recipe,
                   const SizeLimits& limits, Progress& progress, Cache* cache);

}  // namespace meristem
