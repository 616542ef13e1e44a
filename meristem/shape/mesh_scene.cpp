// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/mesh_scene.h"

#include <cstddef>

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
    // Most instances cannot reach beyond those before them; only of the others are all vertices looked at.
    for (std::size_t i = 0; i < instances.count(); ++i) {
      const Frame frame = instances.frame(i);
      if (!contains(box, box_in(mesh_box, frame))) box.add(box_of(*instances.mesh, frame));
    }
  }
  return box;
}

namespace {

MeshScene make_meshes(const Plant& plant, const OwnMeshOptions& options, Progress& progress) {
  const auto& [limits, detail, cache, use] = options;
  if (has_deformed_plantings(plant)) {
    return make_meshes(with_deformed_copies(plant, limits, progress), options, progress);
  }
  check_detail(detail);
  MeshScene scene = make_own_meshes(plant, options, progress);
  if (!has_plantings(plant)) return scene;
  const PlantingRecipe recipe{
      .make =
          [&](const PlantVariant& variant, Progress& part) {
            const OwnMeshOptions of_variant{options.limits, options.detail, nullptr, options.use};
            return VariantMeshes{make_meshes(*variant.plant, of_variant, part), options.detail.level == 0};
          },
      .add_key = [&](const PlantVariant&, Fingerprint& key) { add_detail(options.detail, key); }};
  add_plantings(scene, plant, recipe, limits, progress, cache);
  return scene;
}

}  // namespace

MeshScene make_mesh_scene(const Plant& plant, const Limits& limits, Progress& progress, const Detail& detail,
                          Cache* cache) {
  return make_meshes(plant, {limits, detail, cache}, progress);
}

MeshScene make_ray_meshes(const Plant& plant, const Limits& limits, Progress& progress) {
  return make_meshes(plant, {limits, Detail(), nullptr, MeshUse::rays}, progress);
}

}  // namespace meristem
