// SPDX-License-Identifier: Apache-2.0
// Makes the meshes of placed plants. Distinct variants are meshed in parallel, each once. Their meshes are then added
// to the scene with the places of each planting, and nested places are multiplied out.
#include "meristem/shape/assembly/planting_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <set>
#include <string>
#include <typeinfo>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/shape/assembly/own_meshes.h"
#include "meristem/shape/mesh/even_order.h"

namespace meristem {
namespace {

constexpr std::size_t kFewPlaces = 16;  // number of places of a planting that are always shown

/// Makes the meshes of plantings, each variant once.
class PlantingClothier {
 public:
  PlantingClothier(std::vector<Planting> plantings, const PlantingRecipe& recipe, const SizeLimits& limits,
                   Progress& progress, Cache* cache)
      : plantings_(std::move(plantings)),
        recipe_(recipe),
        limits_(limits),
        progress_(progress),
        results_(cache, {typeid(VariantMeshes)}) {}

  bool add_to(MeshScene& scene) {
    take_variants();
    clothe_variants();
    for (std::uint32_t k = 0; k < plantings_.size(); ++k) add(k, scene);
    check_limits(scene);
    scene.meshes = grouped(std::move(scene.meshes));
    results_.end();
    return is_whole_;
  }

 private:
  /// Collects the distinct variants of the plantings.
  void take_variants() {
    std::unordered_map<const PlantVariant*, std::size_t> number;
    for (Planting& planting : plantings_) {
      const auto [known, is_new] = number.try_emplace(planting.variant.get(), variants_.size());
      variant_of_.push_back(known->second);
      std::shared_ptr<const PlantVariant> variant = std::move(planting.variant);
      if (is_new) {
        pictured_.push_back(variant->materials());
        variants_.push_back(std::move(variant));
      }
      uses_.resize(variants_.size());
      ++uses_[known->second];
    }
  }

  /// Returns a variant. Keeps no reference to it unless its places must still be chosen.
  std::shared_ptr<const PlantVariant> take_variant(std::size_t k) {
    return recipe_.shown_places ? variants_[k] : std::move(variants_[k]);
  }

  /// Runs in parallel. If several variants fail, the choice of the thrown error does not depend on threads.
  void clothe_variants() {
    meshes_.resize(variants_.size());
    std::vector<CacheKey> keys(variants_.size());  // empty for variants whose content is unknown
    for (std::size_t k = 0; k < variants_.size(); ++k) {
      if (variants_[k]->key != 0) {
        keys[k] = results_.key([&] {
          Fingerprint key;
          recipe_.add_key(*variants_[k], key.add(variants_[k]->key));
          return key.hash();
        });
        meshes_[k] = results_.find<const VariantMeshes>(keys[k]);
      }
      results_.count<VariantMeshes>(meshes_[k] != nullptr);
    }
    std::vector<std::exception_ptr> errors(variants_.size());
    std::mutex storing;
    progress_.begin("meshing plants", variants_.size());
    parallel_for(variants_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        if (meshes_[k] == nullptr) {
          Progress part(&progress_);
          try {
            auto made = std::make_shared<VariantMeshes>(recipe_.make(take_variant(k), part));
            meshes_[k] = made;
            const std::lock_guard lock(storing);
            results_.store(keys[k], std::move(made));
          } catch (const InputError&) {
            errors[k] = std::current_exception();
          }
        }
        progress_.advance();
      }
    });
    for (const std::exception_ptr& error : errors) {
      if (error) std::rethrow_exception(error);
    }
  }

  void add(std::uint32_t number, MeshScene& scene) {
    const Planting& planting = plantings_[number];
    const std::size_t variant = variant_of_[number];
    MeshScene& own = std::const_pointer_cast<VariantMeshes>(meshes_[variant])->scene;
    // The last planting takes the frames of the variant without a copy, unless a cache keeps them.
    const bool is_last = --uses_[variant] == 0 && meshes_[variant].use_count() == 1;
    auto places = std::make_shared<std::vector<Frame>>();
    for (const std::size_t place : shown_places(planting, variant, own))
      places->push_back(planting.places[place].frame);
    const bool shows_all = places->size() == planting.places.size();
    is_whole_ = is_whole_ && shows_all && meshes_[variant]->is_whole;
    const std::vector<std::uint32_t>& materials = materials_of(variant, planting.component, scene);
    std::map<const std::vector<Frame>*, std::shared_ptr<const std::vector<Frame>>> multiplied;
    for (MeshInstances& part : own.meshes) {
      MeshInstances& placed = scene.meshes.emplace_back(is_last ? std::move(part) : part);
      const auto inner_places = std::exchange(placed.places, places);
      placed.component = planting.component + "." + placed.component;
      placed.material = materials[placed.material];
      std::vector<std::uint32_t>().swap(placed.individuals);  // each instance is a plant
      // If some places are not shown, frames no longer correspond to all places in their order.
      if (!shows_all) placed.origin = nullptr;
      if (placed.origin != nullptr) {
        placed.origin = std::make_shared<const MeshOrigin>(MeshOrigin{.planting = number, .inner = placed.origin});
      }
      if (inner_places == nullptr) continue;
      // A plant within this one stands on each of its own places at each place of this one.
      std::shared_ptr<const std::vector<Frame>>& all = multiplied[inner_places.get()];
      if (all == nullptr) all = product(*places, *inner_places);
      placed.places = all;
    }
  }

  /// Returns an even choice of a planting's places, in their order.
  std::vector<std::size_t> shown_places(const Planting& planting, std::size_t variant, const MeshScene& made) const {
    std::vector<std::size_t> shown(planting.places.size());
    std::iota(shown.begin(), shown.end(), 0);
    if (!recipe_.shown_places || shown.size() < kFewPlaces) return shown;
    const double share = recipe_.shown_places(*variants_[variant], made.triangle_count());
    if (share >= 1) return shown;
    const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(shown.size())));
    const std::vector<std::uint32_t> order =
        even_order(shown.size(), RandomKey().child("places").child(planting.component));
    shown.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(wanted, 1)));
    std::sort(shown.begin(), shown.end());
    return shown;
  }

  static std::shared_ptr<const std::vector<Frame>> product(const std::vector<Frame>& outer,
                                                           const std::vector<Frame>& inner) {
    auto all = std::make_shared<std::vector<Frame>>();
    all->reserve(outer.size() * inner.size());
    for (const Frame& frame : outer) {
      for (const Frame& place : inner) all->push_back(frame * place);
    }
    return all;
  }

  /// Returns the indices of a variant's materials in the scene. Variants of a component share equal materials.
  const std::vector<std::uint32_t>& materials_of(std::size_t variant, const std::string& component, MeshScene& scene) {
    const auto [known, is_new] = materials_.try_emplace({variant, component});
    if (!is_new) return known->second;
    const std::vector<Material>& pictured = pictured_[variant];
    const std::vector<Material>& all = meshes_[variant]->scene.materials;
    for (std::size_t m = 0; m < all.size(); ++m) {
      Material material = all[m];
      if (m < pictured.size()) material.texture = pictured[m].texture;  // the plant's own materials come first
      material.name = component + "." + material.name;
      std::vector<std::uint32_t>& namesakes = namesakes_[material.name];
      const auto is_it = [&](std::uint32_t known_one) { return look_alike(scene.materials[known_one], material); };
      const auto found = std::ranges::find_if(namesakes, is_it);
      if (found != namesakes.end()) {
        known->second.push_back(*found);
        continue;
      }
      namesakes.push_back(static_cast<std::uint32_t>(scene.materials.size()));
      known->second.push_back(namesakes.back());
      scene.materials.push_back(std::move(material));
    }
    return known->second;
  }

  /// Textures are equal if they have equal sources.
  static bool look_alike(const Material& a, Material b) {
    if (a.texture != nullptr && b.texture != nullptr && a.texture->fingerprint == b.texture->fingerprint) {
      b.texture = a.texture;
    }
    return a == b;
  }

  /// Each variant counts once, because its copies use no memory.
  void check_limits(const MeshScene& scene) const {
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;
    std::set<const Mesh*> known;
    for (const MeshInstances& instances : scene.meshes) {
      triangles += instances.mesh->triangle_count() * instances.frames.size();
      if (known.insert(instances.mesh.get()).second) bytes += instances.mesh->bytes();
      bytes += instances.frames.size() * sizeof(Frame) + instances.place_count() * sizeof(Frame);
    }
    const std::string path = "components." + plantings_.front().component;
    if (triangles > limits_.triangles) {
      throw_limit("triangles", static_cast<double>(triangles), limits_.triangles, "triangles", path);
    }
    if (bytes > limits_.mesh_bytes) {
      throw_limit("bytes of geometry", static_cast<double>(bytes), limits_.mesh_bytes, "mesh_bytes", path);
    }
  }

  std::vector<Planting> plantings_;  // without their variants
  const PlantingRecipe& recipe_;
  const SizeLimits& limits_;
  Progress& progress_;
  CacheRun results_;
  bool is_whole_ = true;
  std::vector<std::shared_ptr<const PlantVariant>> variants_;  // null when no longer needed
  std::vector<std::vector<Material>> pictured_;                // materials of each variant, with pictures
  std::vector<std::size_t> variant_of_;                        // for each planting
  std::vector<std::size_t> uses_;  // for each variant, the number of plantings that are not yet in the scene
  std::vector<std::shared_ptr<const VariantMeshes>> meshes_;
  std::map<std::pair<std::size_t, std::string>, std::vector<std::uint32_t>> materials_;
  std::unordered_map<std::string, std::vector<std::uint32_t>> namesakes_;  // materials by name
};

}  // namespace

bool add_plantings(MeshScene& scene, std::vector<Planting> plantings, const PlantingRecipe& recipe,
                   const SizeLimits& limits, Progress& progress, Cache* cache) {
  return PlantingClothier(std::move(plantings), recipe, limits, progress, cache).add_to(scene);
}

}  // namespace meristem
