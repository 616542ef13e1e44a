// SPDX-License-Identifier: Apache-2.0
// Grows a document in stages: the plant with sketches of its textures, its meshes, and the painted textures. A growth
// can stop after any stage and be completed later. Variants of plants from other documents share their meshes and
// pictures.
#include "meristem/document/grow.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include "meristem/base/large_memory.h"
#include "meristem/components/organize.h"
#include "meristem/document/obstacle_warnings.h"
#include "meristem/document/placing_errors.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/expand.h"
#include "meristem/graph/looks.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/assembly/ray_meshes.h"
#include "meristem/shape/stem/cached_meshes.h"

namespace meristem {

namespace {

/// Replaces texture sketches in the plants that a plant's plantings show, at any depth.
class VariantPainter {
 public:
  explicit VariantPainter(Progress& progress) : progress_(progress) {}

  /// Replaces variants with sketches by variants with painted textures.
  void paint(std::vector<Planting>& plantings) {
    for (Planting& planting : plantings) planting.variant = painted(planting.variant);
  }
  /// Replaces sketches in the materials of meshes.
  void paint(std::vector<Material>& materials) const {
    for (Material& material : materials) {
      const auto found = pictures_.find(material.texture.get());
      if (found != pictures_.end()) material.texture = found->second;
    }
  }

 private:
  std::shared_ptr<const PlantVariant> painted(const std::shared_ptr<const PlantVariant>& variant) {
    std::shared_ptr<const PlantVariant>& known = painted_[variant.get()];
    if (known != nullptr) return known;
    auto fresh = std::make_shared<PlantVariant>(*variant);
    const std::vector<Material>& sketches = variant->plant->materials;
    auto materials = std::make_shared<std::vector<Material>>(variant->materials());
    if (variant->painted == nullptr && variant->paint) variant->paint(*materials, progress_, &textures_);
    for (std::size_t m = 0; m < materials->size(); ++m) {
      if (sketches[m].texture != nullptr) pictures_[sketches[m].texture.get()] = (*materials)[m].texture;
    }
    fresh->painted = std::move(materials);
    if (has_plantings(*variant->plant)) {
      auto plant = std::make_shared<Plant>(*variant->plant);
      paint(plant->plantings);
      fresh->plant = std::move(plant);
    }
    return known = std::move(fresh);
  }

  Progress& progress_;
  Cache textures_;  // lets equal textures of several variants be painted once and shared
  CacheSeries series_{textures_};
  std::unordered_map<const PlantVariant*, std::shared_ptr<const PlantVariant>> painted_;
  std::unordered_map<const Texture*, std::shared_ptr<const Texture>> pictures_;  // by sketch
};

/// Paints the textures of the plant, which its meshes share. Changes only textures, so other threads may read the plant
/// at the same time.
void paint_variants(const Document& document, GrownDocument& grown, Progress& progress, GrowthCache* cache) {
  std::vector<Material> painted = grown.plant.materials;
  paint_textures(document.graph, painted, progress, cache);
  // The materials of the meshes begin with the plant's materials.
  for (std::vector<Material>* materials : {&grown.plant.materials, &grown.meshes.materials}) {
    const std::size_t count = std::min(painted.size(), materials->size());
    for (std::size_t m = 0; m < count; ++m) (*materials)[m].texture = painted[m].texture;
  }
  if (!has_plantings(grown.plant)) return;
  VariantPainter variants(progress);
  variants.paint(grown.plant.plantings);
  variants.paint(grown.meshes.materials);
}

}  // namespace

std::vector<ReuseCount> reuse_of(const GrowthCache& cache) {
  std::vector<ReuseCount> counts{
      {"grown skeletons", cache.reuse<GrownBatch>()}, {"placed plants", cache.reuse<PlantVariant>()},
      {"instances", cache.reuse<BatchResult>()},      {"clothed stems", cache.reuse<StemTubes>()},
      {"closed bodies", cache.reuse<BodyMesh>()},     {"painted textures", cache.reuse<Texture>()}};
  std::erase_if(counts, [](const ReuseCount& one) { return one.count.made + one.count.reused == 0; });
  return counts;
}

GrownDocument grow_document(const Document& document, Progress& progress, const GrowthOptions& options) {
  std::optional<Document> other;
  const Document& now = document_at(document, options.time, other, &progress);
  if (&now != &document) return grow_document(now, progress, options);
  GrownDocument grown;
  grown.plant = placing_errors(document, [&] {
    const bool will_mesh = options.up_to >= GrownPart::meshes && options.detail.level == 0;
    const ExpandOptions expansion{options.cache, options.view, &grown.traces, will_mesh};
    return expand(document.graph, document.scene, options.time, progress, expansion);
  });
  grown.warnings = obstacle_warnings(document.graph, document.scene.obstacles, grown.plant, progress);
  for (const Prototype& component : document.graph.components) {
    if (!leans_in_vain(component, document.scene.light)) continue;
    grown.warnings.push_back({.severity = Severity::warning,
                              .message = "'lean' has no effect: the light of the scene comes from straight above",
                              .path = "components." + component.id + ".light.lean"});
  }
  document.source.place(grown.warnings);
  if (options.keeps_plant || options.up_to < GrownPart::meshes) {
    complete_growth(document, grown, progress, options);
    return grown;
  }
  if (options.up_to >= GrownPart::textures) paint_plant(document, grown.plant, progress, options.cache);
  grown.meshes = placing_errors(document, [&] {
    return make_mesh_scene(std::exchange(grown.plant, Plant()), document.graph.limits, progress, options.detail);
  });
  grown.up_to = options.up_to;
  give_back_memory();
  return grown;
}

void complete_growth(const Document& document, GrownDocument& grown, Progress& progress, const GrowthOptions& options) {
  if (grown.up_to < GrownPart::meshes && options.up_to >= GrownPart::meshes) {
    grown.meshes = mesh_detail(document, grown.plant, options.detail, progress, options.cache);
    grown.up_to = GrownPart::meshes;
  }
  if (grown.up_to < GrownPart::textures && options.up_to >= GrownPart::textures) {
    paint_variants(document, grown, progress, options.cache);
    grown.up_to = GrownPart::textures;
  }
}

void paint_plant(const Document& document, Plant& plant, Progress& progress, GrowthCache* cache) {
  paint_textures(document.graph, plant.materials, progress, cache);
  if (has_plantings(plant)) VariantPainter(progress).paint(plant.plantings);
}

MeshScene mesh_detail(const Document& document, const Plant& plant, const MeshDetail& detail, Progress& progress,
                      GrowthCache* cache) {
  return placing_errors(document,
                        [&] { return make_mesh_scene(plant, document.graph.limits, progress, detail, cache); });
}

MeshScene mesh_for_rays(const Document& document, const Plant& plant, Progress& progress) {
  return placing_errors(document, [&] { return make_ray_meshes(plant, document.graph.limits, progress); });
}

MeshScene mesh_for_rays(const Document& document, Plant&& plant, Progress& progress) {
  MeshScene meshes =
      placing_errors(document, [&] { return make_ray_meshes(std::move(plant), document.graph.limits, progress); });
  give_back_memory();
  return meshes;
}

GeometryCount count_geometry(const Document& document, const Plant& plant, Progress& progress) {
  return placing_errors(document, [&] { return count_geometry(plant, document.graph.limits, progress); });
}

ViewMeshes view_meshes(const Document& document, const Plant& plant, const ViewMeshOptions& options, Progress& progress,
                       GrowthCache* cache) {
  return placing_errors(document,
                        [&] { return make_view_meshes(plant, document.graph.limits, options, progress, cache); });
}

}  // namespace meristem
