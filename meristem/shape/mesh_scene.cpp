// SPDX-License-Identifier: Apache-2.0
// Makes mesh scenes: the plant's own meshes, then the meshes of placed plants, grouped by component. Ownership decides
// when parts of the plant can be freed.
#include "meristem/shape/mesh_scene.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <glm/vector_relational.hpp>

#include "meristem/plant/plant_bounds.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/own_meshes.h"
#include "meristem/shape/planting_meshes.h"
#include "meristem/shape/ray_meshes.h"

namespace meristem {
namespace {

Box box_of(const Mesh& mesh, const Frame& frame) {
  Box box;
  for (const Vec3 position : mesh.positions) box.add(frame.point(position));
  return box;
}

bool contains(const Box& outer, const Box& inner) {
  return glm::all(glm::lessThanEqual(outer.low, inner.low)) && glm::all(glm::lessThanEqual(inner.high, outer.high));
}

}  // namespace

std::string object_name(const MeshInstances& instances) {
  return instances.is_crown ? instances.component + "_crown" : instances.component;
}

std::uint64_t MeshScene::triangle_count() const {
  std::uint64_t count = 0;
  for (const MeshInstances& instances : meshes) count += instances.triangle_count();
  return count;
}

std::uint64_t MeshScene::instance_count() const {
  std::uint64_t count = 0;
  for (const MeshInstances& instances : meshes) count += instances.count();
  return count;
}

Box MeshScene::bounds() const {
  Box box;
  for (const MeshInstances& instances : meshes) {
    const Box mesh_box = box_of(*instances.mesh, Frame{});
    // Most instances cannot extend the box further. Check all vertices only for the others.
    for (std::size_t i = 0; i < instances.count(); ++i) {
      const Frame frame = instances.frame(i);
      if (!contains(box, box_in(mesh_box, frame))) box.add(box_of(*instances.mesh, frame));
    }
  }
  return box;
}

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

MeshScene make_mesh_scene(const Plant& plant, const Limits& limits, Progress& progress, const Detail& detail,
                          Cache* cache) {
  return make_meshes(borrowed(plant), {limits, detail, cache}, progress);
}

MeshScene make_mesh_scene(Plant&& plant, const Limits& limits, Progress& progress, const Detail& detail) {
  return make_meshes(std::make_shared<const Plant>(std::move(plant)), {limits, detail}, progress);
}

MeshScene make_ray_meshes(const Plant& plant, const Limits& limits, Progress& progress) {
  return make_meshes(borrowed(plant), {limits, Detail(), nullptr, MeshUse::rays}, progress);
}

MeshScene make_ray_meshes(Plant&& plant, const Limits& limits, Progress& progress) {
  return make_meshes(std::make_shared<const Plant>(std::move(plant)), {limits, Detail(), nullptr, MeshUse::rays},
                     progress);
}

}  // namespace meristem
