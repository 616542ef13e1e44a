// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/mesh_scene.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <typeinfo>
#include <unordered_map>
#include <utility>

#include <glm/vector_relational.hpp>

#include "meristem/base/deform/deformation.h"
#include "meristem/base/parallel.h"
#include "meristem/plant/plant_bounds.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/body_meshes.h"
#include "meristem/shape/cached_meshes.h"
#include "meristem/shape/detail_plan.h"
#include "meristem/shape/mesh/tangents.h"
#include "meristem/shape/ray_meshes.h"
#include "meristem/shape/scene_tally.h"
#include "meristem/shape/small_detail.h"
#include "meristem/shape/stem_looks.h"
#include "meristem/shape/stem_tubes.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem {
namespace {

constexpr std::size_t kOrgansPerBlock = 16384;

/// What the meshes are for.
enum class MeshUse {
  all,
  rays,  // what only pictures show is left out
};

void check_references(const Plant& plant) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(message);
  };
  const std::size_t individuals = std::max<std::size_t>(1, plant.individuals.size());
  const auto is_individual = [&](std::uint32_t number) { return number < individuals || number == kNoIndividual; };
  for (const Stem& stem : plant.stems) {
    for (const std::uint32_t number : stem.individual_of_root) {
      require(is_individual(number), "a stem has no such individual");
    }
    for (const StemPart& part : stem.parts) {
      require(part.material < plant.materials.size(), "a stem has no such material");
      require(part.surface.uv_scale > 0, "a surface's uv_scale must be above 0");
    }
  }
  for (const OrganPrototype& prototype : plant.prototypes) {
    require(prototype.mesh != nullptr, "an organ prototype has no mesh");
    require(prototype.material < plant.materials.size(), "an organ prototype has no such material");
  }
  for (const Organ& organ : plant.organs) {
    require(organ.prototype < plant.prototypes.size(), "an organ has no such prototype");
    require(is_individual(organ.individual), "an organ has no such individual");
  }
}

std::vector<std::size_t> organs_of_prototypes(const Plant& plant, const OrganDetail& organs) {
  std::vector<std::size_t> counts(plant.prototypes.size(), 0);
  for (std::size_t i = 0; i < plant.organs.size(); ++i) counts[plant.organs[i].prototype] += organs.shows(i) ? 1 : 0;
  return counts;
}

/// One stem's tubes: those of parts that look alike share a mesh. They are planned where they were not made before.
struct StemDress {
  StemLooks looks;
  CacheKey key;
  std::optional<TubePlan> plan;
  std::shared_ptr<const StemTubes> tubes;

  explicit StemDress(const Stem& stem) : looks(stem) {}

  const std::vector<TubeSize>& sizes() const { return tubes != nullptr ? tubes->sizes : plan->sizes(); }
};

/// Hash of all that shapes a stem's tubes.
std::uint64_t key_of(const Stem& stem, const StemLooks& looks, const std::vector<Material>& materials, double share) {
  Fingerprint key;
  add_skeleton(stem, key);
  key.add(share);
  for (const StemPart& part : stem.parts) add_surface(part.surface, key);
  key.add_array(stem.part_of_axis).add_array(looks.mesh_of_part).add_array(looks.mesh_of_axis);
  for (const StemPart* part : looks.first_part) key.add(needs_tangents(materials[part->material]));
  return key.hash();
}

std::vector<std::unique_ptr<StemDress>> plan_stems(const Plant& plant, double share, CacheRun& results) {
  std::vector<std::unique_ptr<StemDress>> dresses(plant.stems.size());
  parallel_for(dresses.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      dresses[i] = std::make_unique<StemDress>(plant.stems[i]);
      dresses[i]->key = results.key([&] { return key_of(plant.stems[i], dresses[i]->looks, plant.materials, share); });
    }
  });
  for (const std::unique_ptr<StemDress>& dress : dresses) {
    dress->tubes = results.find<const StemTubes>(dress->key);
    results.count<StemTubes>(dress->tubes != nullptr);
  }
  parallel_for(dresses.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (dresses[i]->tubes == nullptr) dresses[i]->plan = plan_stem(plant.stems[i], dresses[i]->looks, share);
    }
  });
  return dresses;
}

/// What a plant's stems and organs will make.
struct ScenePlan {
  std::vector<std::unique_ptr<StemDress>> stems;
  OrganDetail organs;
  std::vector<std::size_t> organ_counts;  // of each prototype

  ScenePlan(const Plant& plant, const Detail& detail, CacheRun& results)
      : ScenePlan(plant, detail, DetailBudget(plant, detail), results) {}

 private:
  ScenePlan(const Plant& plant, const Detail& detail, const DetailBudget& budget, CacheRun& results)
      : stems(plan_stems(plant, budget.of_tubes(detail.level), results)),
        organs(plan_organs(plant, detail, budget)),
        organ_counts(organs_of_prototypes(plant, organs)) {}
};

/// Throws where the scene would pass a limit.
void check_limits(const Plant& plant, const std::vector<MeshInstances>& bodies, const ScenePlan& scene,
                  const Limits& limits) {
  SceneTally tally;
  for (const MeshInstances& body : bodies) tally.add_mesh(body.component, *body.mesh);
  for (const std::unique_ptr<StemDress>& dress : scene.stems) tally.add_tubes(dress->looks, dress->sizes());
  for (std::size_t i = 0; i < plant.prototypes.size(); ++i) {
    tally.add_organs(plant.prototypes[i].component, *scene.organs.meshes[i], scene.organ_counts[i]);
  }
  tally.check(limits);
}

/// The tubes of each mesh of a plan, by their first triangles.
std::vector<std::shared_ptr<const std::vector<AxisTriangles>>> tubes_of(const TubePlan& plan) {
  std::vector<std::vector<AxisTriangles>> tubes(plan.sizes().size());
  for (std::size_t axis = 0; axis < plan.axis_count(); ++axis) {
    if (plan[axis].triangles() == 0) continue;
    tubes[plan[axis].mesh].push_back(
        {static_cast<std::uint32_t>(plan[axis].first_triangle), static_cast<AxisIndex>(axis)});
  }
  std::vector<std::shared_ptr<const std::vector<AxisTriangles>>> shared;
  for (std::vector<AxisTriangles>& of_mesh : tubes) {
    shared.push_back(std::make_shared<const std::vector<AxisTriangles>>(std::move(of_mesh)));
  }
  return shared;
}

/// Removes what rays do not need, and frees its memory.
void strip_for_rays(Mesh& mesh, const Material& material) {
  std::vector<Vec3>().swap(mesh.normals);
  if (material.texture == nullptr || !material.texture->masked) std::vector<Vec2>().swap(mesh.uvs);
}

std::shared_ptr<const StemTubes> make_stem(const StemDress& dress, const std::vector<Material>& materials, MeshUse use,
                                           Progress& progress) {
  auto tubes = std::make_shared<StemTubes>();
  tubes->sizes = dress.plan->sizes();
  tubes->tubes = tubes_of(*dress.plan);
  std::vector<Mesh> meshes = make_stem_tubes(*dress.plan, dress.looks, progress);
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    const Material& material = materials[dress.looks.first_part[k]->material];
    if (use == MeshUse::rays) {
      strip_for_rays(meshes[k], material);
    } else if (needs_tangents(material)) {
      add_tangents(meshes[k]);
    }
    tubes->meshes.push_back(std::make_shared<const Mesh>(std::move(meshes[k])));
  }
  return tubes;
}

/// The tubes of each stem.
std::vector<MeshInstances> clothe_stems(const Plant& plant, const std::vector<std::unique_ptr<StemDress>>& dresses,
                                        MeshUse use, CacheRun& results, Progress& progress) {
  std::vector<std::uint8_t> is_new(dresses.size());
  parallel_for(dresses.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      is_new[i] = dresses[i]->tubes == nullptr ? 1 : 0;
      if (is_new[i] != 0) {
        dresses[i]->tubes = make_stem(*dresses[i], plant.materials, use, progress);
      } else {
        progress.advance(plant.stems[i].skeleton.node_count());
      }
    }
  });
  std::vector<MeshInstances> all;
  for (std::size_t i = 0; i < dresses.size(); ++i) {
    const StemDress& dress = *dresses[i];
    if (is_new[i] != 0) results.store(dress.key, dress.tubes);
    for (std::size_t k = 0; k < dress.tubes->meshes.size(); ++k) {
      const StemPart& look = *dress.looks.first_part[k];
      MeshInstances& instances = all.emplace_back();
      instances.component = look.component;
      instances.mesh = dress.tubes->meshes[k];
      instances.material = look.material;
      instances.frames = {Frame{}};
      instances.origin = std::make_shared<const MeshOrigin>(
          MeshOrigin{.stem = static_cast<std::uint32_t>(i), .tubes = dress.tubes->tubes[k]});
      if (look.tint != Vec3(1)) instances.tints = {look.tint};
      if (dress.looks.individual[k] != 0) instances.individuals = {dress.looks.individual[k]};
    }
  }
  return all;
}

/// The mesh as a material needs it.
std::shared_ptr<const Mesh> with_cached_tangents(const std::shared_ptr<const Mesh>& mesh, const Material& material,
                                                 CacheRun& results) {
  if (!needs_tangents(material) || !mesh->tangents.empty()) return mesh;
  const CacheKey key = Fingerprint().add(reinterpret_cast<std::uintptr_t>(mesh.get())).hash();
  std::shared_ptr<const TangentMesh> found = results.find<const TangentMesh>(key);
  if (found == nullptr) {
    found = std::make_shared<const TangentMesh>(TangentMesh{mesh, with_needed_tangents(mesh, material)});
    results.store(key, found);
  }
  return found->mesh;
}

/// Enlarges about a point: about an organ's base the crown's outline would grow by all that leaves become longer.
Frame enlarged(float scale, Vec3 about) { return {Mat3(scale), (1 - scale) * about}; }

/// The frames of each prototype's organs, in the order of the organs.
std::vector<MeshInstances> place_organs(const Plant& plant, const ScenePlan& scene, MeshUse use, CacheRun& results,
                                        Progress& progress) {
  std::vector<MeshInstances> placed(plant.prototypes.size());
  std::vector<Vec3> centres(placed.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const OrganPrototype& prototype = plant.prototypes[i];
    auto mesh = with_cached_tangents(scene.organs.meshes[i], plant.materials[prototype.material], results);
    placed[i] = {prototype.component, std::move(mesh), prototype.material, {}, {}, {}};
    // Where some organs are not shown, frames are no longer the organs in their order.
    if (scene.organs.shown.empty()) {
      placed[i].origin = std::make_shared<const MeshOrigin>(MeshOrigin{.prototype = static_cast<std::uint32_t>(i)});
    }
    placed[i].frames.reserve(scene.organ_counts[i]);
    if (use == MeshUse::all) placed[i].tints.reserve(scene.organ_counts[i]);
    if (plant.individuals.size() > 1) placed[i].individuals.reserve(scene.organ_counts[i]);
    Box box;
    for (const Vec3 position : placed[i].mesh->positions) box.add(position);
    centres[i] = box.is_empty() ? Vec3(0) : box.centre();
  }
  for (std::size_t begin = 0; begin < plant.organs.size(); begin += kOrgansPerBlock) {
    const std::size_t end = std::min(begin + kOrgansPerBlock, plant.organs.size());
    for (std::size_t i = begin; i < end; ++i) {
      if (!scene.organs.shows(i)) continue;
      const Organ& organ = plant.organs[i];
      MeshInstances& instances = placed[organ.prototype];
      instances.frames.push_back(organ.frame);
      if (!scene.organs.scale.empty()) {
        instances.frames.back() = organ.frame * enlarged(scene.organs.scale[organ.prototype], centres[organ.prototype]);
      }
      if (use == MeshUse::all) instances.tints.push_back(organ.tint);
      if (plant.individuals.size() > 1) instances.individuals.push_back(organ.individual);
    }
    progress.advance(end - begin);
  }
  for (MeshInstances& instances : placed) {
    const auto is_plain = [](Vec3 tint) { return tint == Vec3(1); };
    if (std::all_of(instances.tints.begin(), instances.tints.end(), is_plain)) {
      std::vector<Vec3>().swap(instances.tints);  // which frees its memory
    }
  }
  return placed;
}

/// Brings what belongs to one component together, in the order of first appearance; leaves out what is not to be seen.
std::vector<MeshInstances> grouped(std::vector<MeshInstances> meshes) {
  std::map<std::string, std::size_t> rank;
  for (const MeshInstances& instances : meshes) rank.try_emplace(instances.component, rank.size());
  std::erase_if(meshes, [](const MeshInstances& instances) { return instances.triangle_count() == 0; });
  std::stable_sort(meshes.begin(), meshes.end(), [&rank](const MeshInstances& a, const MeshInstances& b) {
    return rank.at(a.component) < rank.at(b.component);
  });
  return meshes;
}

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

/// Whether a plant's tubes and organs have few triangles; what its bodies will have, nobody knows yet.
bool may_be_small(const Plant& plant) {
  std::uint64_t triangles = 0;
  std::size_t nodes = 0;
  for (const Organ& organ : plant.organs) {
    triangles += plant.prototypes[organ.prototype].mesh->triangle_count();
    if (triangles > kSmallPlant) return false;
  }
  for (const Stem& stem : plant.stems) nodes += stem.skeleton.node_count();
  return nodes <= kSmallPlant;
}

/// What is made of a plant besides itself.
struct Wanted {
  const Limits& limits;
  const Detail& detail;
  Cache* cache = nullptr;
  MeshUse use = MeshUse::all;
};

MeshScene clothe(const Plant& plant, const Wanted& wanted, Progress& progress) {
  const auto& [limits, detail, cache, use] = wanted;
  CacheRun results(cache, {typeid(StemTubes), typeid(BodyMesh), typeid(TangentMesh)});
  const ScenePlan plan(plant, detail, results);
  check_limits(plant, {}, plan, limits);
  std::vector<Material> materials = plant.materials;
  std::vector<MeshInstances> bodies = make_body_meshes(plant, detail, limits, materials, progress, results);
  check_limits(plant, bodies, plan, limits);
  progress.begin("meshing", plant.node_count() + plant.organs.size());
  std::vector<MeshInstances> meshes = clothe_stems(plant, plan.stems, use, results, progress);
  std::move(bodies.begin(), bodies.end(), std::back_inserter(meshes));
  std::vector<MeshInstances> placed = place_organs(plant, plan, use, results, progress);
  std::move(placed.begin(), placed.end(), std::back_inserter(meshes));
  results.end();
  return {std::move(materials), grouped(std::move(meshes)), plant.individuals};
}

}  // namespace

namespace {

/// The meshes of what stands in a plant's own document.
MeshScene clothe_own(const Plant& plant, const Wanted& wanted, Progress& progress) {
  if (wanted.detail.level > 0 && may_be_small(plant)) {
    const MeshScene whole = clothe(plant, {wanted.limits, Detail(), wanted.cache}, progress);
    if (whole.triangle_count() <= kSmallPlant) return small_detail(whole, wanted.detail, progress);
  }
  return clothe(plant, wanted, progress);
}

MeshScene make_meshes(const Plant& plant, const Wanted& wanted, Progress& progress);

/// The meshes of plantings, each variant's made once.
class PlantingClothier {
 public:
  PlantingClothier(const Wanted& wanted, Progress& progress)
      : wanted_(wanted), progress_(progress), results_(wanted.cache, {typeid(VariantMeshes)}) {}

  void add_to(MeshScene& scene, const Plant& plant) {
    find_variants(plant);
    clothe_variants();
    for (std::uint32_t k = 0; k < plant.plantings.size(); ++k) add(plant.plantings[k], k, scene);
    check_limits(scene, plant);
    scene.meshes = grouped(std::move(scene.meshes));
    results_.end();
  }

 private:
  void find_variants(const Plant& plant) {
    for (const Planting& planting : plant.plantings) {
      const auto [known, is_new] = number_.try_emplace(planting.variant.get(), variants_.size());
      if (is_new) variants_.push_back(planting.variant);
      uses_.resize(variants_.size());
      ++uses_[known->second];
    }
  }

  /// Side by side; which of several faults is thrown does not depend on threads.
  void clothe_variants() {
    meshes_.resize(variants_.size());
    const auto key_of_variant = [&](std::size_t k) {
      return results_.key([&] {
        Fingerprint key;
        add_detail(wanted_.detail, key.add(variants_[k]->key));
        return key.hash();
      });
    };
    for (std::size_t k = 0; k < variants_.size(); ++k) {
      if (variants_[k]->key != 0) meshes_[k] = results_.find<const VariantMeshes>(key_of_variant(k));
      results_.count<VariantMeshes>(meshes_[k] != nullptr);
    }
    std::vector<std::exception_ptr> faults(variants_.size());
    progress_.begin("meshing plants", variants_.size());
    parallel_for(variants_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        if (meshes_[k] == nullptr) {
          Progress part(&progress_);
          try {
            meshes_[k] = std::make_shared<VariantMeshes>(VariantMeshes{
                make_meshes(*variants_[k]->plant, {wanted_.limits, wanted_.detail, nullptr, wanted_.use}, part)});
          } catch (const InputError&) {
            faults[k] = std::current_exception();
          }
        }
        progress_.advance();
      }
    });
    for (const std::exception_ptr& fault : faults) {
      if (fault) std::rethrow_exception(fault);
    }
    for (std::size_t k = 0; k < variants_.size(); ++k) {
      if (variants_[k]->key != 0) results_.store(key_of_variant(k), std::const_pointer_cast<VariantMeshes>(meshes_[k]));
    }
  }

  void add(const Planting& planting, std::uint32_t number, MeshScene& scene) {
    const std::size_t variant = number_.at(planting.variant.get());
    MeshScene& own = std::const_pointer_cast<VariantMeshes>(meshes_[variant])->scene;
    // Its last planting takes the frames of the variant without a copy, unless a cache keeps them.
    const bool is_last = --uses_[variant] == 0 && meshes_[variant].use_count() == 1;
    auto places = std::make_shared<std::vector<Frame>>();
    for (const Planting::Place& place : planting.places) places->push_back(place.frame);
    const std::vector<std::uint32_t>& materials = materials_of(variant, planting.component, scene);
    std::map<const std::vector<Frame>*, std::shared_ptr<const std::vector<Frame>>> multiplied;
    for (MeshInstances& part : own.meshes) {
      MeshInstances& placed = scene.meshes.emplace_back(is_last ? std::move(part) : part);
      const auto inner_places = std::exchange(placed.places, places);
      placed.component = planting.component + "." + placed.component;
      placed.material = materials[placed.material];
      std::vector<std::uint32_t>().swap(placed.individuals);  // each instance is a plant
      if (placed.origin != nullptr) {
        placed.origin = std::make_shared<const MeshOrigin>(MeshOrigin{.planting = number, .inner = placed.origin});
      }
      if (inner_places == nullptr) continue;
      // A plant within this one stands on each of its sites at each site of this one.
      std::shared_ptr<const std::vector<Frame>>& all = multiplied[inner_places.get()];
      if (all == nullptr) all = product(*places, *inner_places);
      placed.places = all;
    }
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

  /// The numbers of a variant's materials in the scene. A component's variants share those that are equal.
  const std::vector<std::uint32_t>& materials_of(std::size_t variant, const std::string& component, MeshScene& scene) {
    const auto [known, is_new] = materials_.try_emplace({variant, component});
    if (!is_new) return known->second;
    const std::vector<Material>& pictured = variants_[variant]->materials();
    const std::vector<Material>& all = meshes_[variant]->scene.materials;
    for (std::size_t m = 0; m < all.size(); ++m) {
      Material material = all[m];
      if (m < pictured.size()) material.texture = pictured[m].texture;  // the plant's own come first
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

  /// Textures are equal where they are made of the same.
  static bool look_alike(const Material& a, Material b) {
    if (a.texture != nullptr && b.texture != nullptr && a.texture->fingerprint == b.texture->fingerprint) {
      b.texture = a.texture;
    }
    return a == b;
  }

  /// Each variant counts once: no memory is spent on its copies.
  void check_limits(const MeshScene& scene, const Plant& plant) const {
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;
    std::set<const Mesh*> known;
    for (const MeshInstances& instances : scene.meshes) {
      triangles += instances.mesh->triangle_count() * instances.frames.size();
      if (known.insert(instances.mesh.get()).second) bytes += instances.mesh->bytes();
      bytes += instances.frames.size() * sizeof(Frame) + instances.place_count() * sizeof(Frame);
    }
    const std::string path = "components." + plant.plantings.front().component;
    if (triangles > wanted_.limits.triangles) {
      throw_limit("triangles", static_cast<double>(triangles), wanted_.limits.triangles, "triangles", path);
    }
    if (bytes > wanted_.limits.mesh_bytes) {
      throw_limit("bytes of geometry", static_cast<double>(bytes), wanted_.limits.mesh_bytes, "mesh_bytes", path);
    }
  }

  const Wanted& wanted_;
  Progress& progress_;
  CacheRun results_;
  std::vector<std::shared_ptr<const PlantVariant>> variants_;
  std::unordered_map<const PlantVariant*, std::size_t> number_;
  std::vector<std::size_t> uses_;  // of each variant: the plantings that are not yet in the scene
  std::vector<std::shared_ptr<const VariantMeshes>> meshes_;
  std::map<std::pair<std::size_t, std::string>, std::vector<std::uint32_t>> materials_;
  std::unordered_map<std::string, std::vector<std::uint32_t>> namesakes_;  // of materials, by name
};

MeshScene make_meshes(const Plant& plant, const Wanted& wanted, Progress& progress) {
  if (has_deformed_plantings(plant)) {
    return make_meshes(with_deformed_copies(plant, wanted.limits, progress), wanted, progress);
  }
  check_references(plant);
  check_detail(wanted.detail);
  MeshScene scene = clothe_own(plant, wanted, progress);
  if (has_plantings(plant)) PlantingClothier(wanted, progress).add_to(scene, plant);
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
