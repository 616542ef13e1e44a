// SPDX-License-Identifier: Apache-2.0
// Makes mesh scenes: the plant's own meshes, then the meshes of placed plants, grouped by component. Ownership decides
// when parts of the plant can be freed.
#include "meristem/shape/assembly/make_mesh_scene.h"

#include <memory>
#include <utility>
#include <vector>

#include "meristem/plant/plant_variant.h"
#include "meristem/shape/assembly/own_meshes.h"
#include "meristem/shape/assembly/planting_meshes.h"
#include "meristem/shape/assembly/ray_meshes.h"

namespace meristem {
namespace {

/// Makes the meshes. Frees the plant after its own meshes were made, and each placed variant after the meshes of the
/// variant were made.
MeshScene make_meshes(std::shared_ptr<const Plant> plant, const OwnMeshOptions& options, Progress& progress) {
  const auto& [limits, detail, cache, use] = options;
  check_detail(detail);
  if (has_deformed_plantings(*plant)) {
    plant = std::make_shared<const Plant>(with_deformed_copies(*plant, limits, progress));
  }
  MeshScene scene = make_own_meshes(*plant, options, progress);
  std::vector<Planting> plantings = plant->plantings;
  plant.reset();
  if (plantings.empty()) return scene;
  const PlantingRecipe recipe{
      .make =
          [&](std::shared_ptr<const PlantVariant> variant, Progress& part) {
            const OwnMeshOptions of_variant{options.limits, options.detail, nullptr, options.use};
            std::shared_ptr<const Plant> placed = variant->plant;
            variant.reset();
            return VariantMeshes{make_meshes(std::move(placed), of_variant, part), options.detail.level == 0};
          },
      .add_key = [&](const PlantVariant&, Fingerprint& key) { add_detail(options.detail, key); }};
  add_plantings(scene, std::move(plantings), recipe, limits, progress, cache);
  return scene;
}

/// Returns a pointer to a plant that has another owner.
std::shared_ptr<const Plant> borrowed(const Plant& plant) { return {std::shared_ptr<const Plant>(), &plant}; }

}  // namespace

MeshScene make_mesh_scene(const Plant& plant, const SizeLimits& limits, Progress& progress, const MeshDetail& detail,
                          Cache* cache) {
  return make_meshes(borrowed(plant), {limits, detail, cache}, progress);
}

MeshScene make_mesh_scene(Plant&& plant, const SizeLimits& limits, Progress& progress, const MeshDetail& detail) {
  return make_meshes(std::make_shared<const Plant>(std::move(plant)), {limits, detail}, progress);
}

MeshScene make_ray_meshes(const Plant& plant, const SizeLimits& limits, Progress& progress) {
  return make_meshes(borrowed(plant), {limits, MeshDetail(), nullptr, MeshUse::rays}, progress);
}

MeshScene make_ray_meshes(Plant&& plant, const SizeLimits& limits, Progress& progress) {
  return make_meshes(std::make_shared<const Plant>(std::move(plant)), {limits, MeshDetail(), nullptr, MeshUse::rays},
                     progress);
}

}  // namespace meristem
