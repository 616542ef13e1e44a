// SPDX-License-Identifier: Apache-2.0
// Makes the meshes of a plant's own stems and organs. Everything is planned first, so that limits are checked before
// memory is used. Then tubes are made, and organs become instances of their prototype's mesh.
#include "meristem/shape/assembly/own_meshes.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <utility>

#include "meristem/base/fingerprint.h"
#include "meristem/base/frame.h"
#include "meristem/base/parallel.h"
#include "meristem/base/random.h"
#include "meristem/shape/detail/detail_budget.h"
#include "meristem/shape/detail/detail_plan.h"
#include "meristem/shape/detail/small_detail.h"
#include "meristem/shape/mesh/even_order.h"
#include "meristem/shape/mesh/tangents.h"
#include "meristem/shape/stem/body_meshes.h"
#include "meristem/shape/stem/cached_meshes.h"
#include "meristem/shape/stem/scene_tally.h"
#include "meristem/shape/stem/stem_looks.h"
#include "meristem/shape/stem/stem_tubes.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem {
namespace {

constexpr std::size_t kOrgansPerBlock = 16384;

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

/// The tubes of one stem. Parts that look alike share a mesh. Tubes are planned unless they are in the cache.
struct StemSurface {
  StemLooks looks;
  CacheKey key;
  std::optional<TubePlan> plan;
  std::shared_ptr<const StemTubes> tubes;

  explicit StemSurface(const Stem& stem) : looks(stem) {}

  const std::vector<TubeSize>& sizes() const { return tubes != nullptr ? tubes->sizes : plan->sizes(); }
};

/// Returns the hash of everything that shapes a stem's tubes.
std::uint64_t key_of(const Stem& stem, const StemLooks& looks, const std::vector<Material>& materials, double share,
                     bool is_quick) {
  Fingerprint key;
  add_skeleton(stem, key);
  key.add(share).add(is_quick && share < 1);
  for (const StemPart& part : stem.parts) add_surface(part.surface, key);
  key.add_array(stem.part_of_axis).add_array(looks.mesh_of_part).add_array(looks.mesh_of_axis);
  for (const StemPart* part : looks.first_part) key.add(needs_tangents(materials[part->material]));
  return key.hash();
}

constexpr double kFewestStemTriangles = 24;  // minimum for a stem in a quick detail

/// Returns the share of its triangles that each stem keeps. If a quick detail has too few triangles for all stems, an
/// even choice of stems and the thickest stem share them, and all other stems get 0.
std::vector<double> shares_of_stems(const Plant& plant, double share, bool is_quick) {
  const std::size_t count = plant.stems.size();
  std::vector<double> shares(count, share);
  if (!is_quick || share >= 1 || count < 2) return shares;
  double triangles = 0;
  std::size_t thickest = 0;
  const auto radius = [&](std::size_t k) {
    return plant.stems[k].skeleton.radius.empty() ? 0 : plant.stems[k].skeleton.radius[0];
  };
  for (std::size_t k = 0; k < count; ++k) {
    const Stem& stem = plant.stems[k];
    for (NodeIndex node = 0; node < stem.skeleton.node_count(); ++node) triangles += about_tube_triangles(stem, node);
    if (radius(k) > radius(thickest)) thickest = k;
  }
  const auto kept = static_cast<std::size_t>(std::max(1.0, share * triangles / kFewestStemTriangles));
  if (kept >= count) return shares;
  const std::vector<std::uint32_t> order = even_order(count, RandomKey().child("stems"));
  for (std::size_t k = kept; k < count; ++k) shares[order[k]] = 0;
  shares[thickest] = share;
  const double larger = std::min(0.99, share * static_cast<double>(count) / static_cast<double>(kept));
  for (double& one : shares) one = one > 0 ? larger : 0;
  return shares;
}

/// Returns null for stems that are left out.
std::vector<std::unique_ptr<StemSurface>> plan_stems(const Plant& plant, double share, bool is_quick,
                                                     CacheRun& results) {
  std::vector<std::unique_ptr<StemSurface>> surfaces(plant.stems.size());
  const std::vector<double> shares = shares_of_stems(plant, share, is_quick);
  parallel_for(surfaces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (shares[i] == 0) continue;
      surfaces[i] = std::make_unique<StemSurface>(plant.stems[i]);
      surfaces[i]->key =
          results.key([&] { return key_of(plant.stems[i], surfaces[i]->looks, plant.materials, shares[i], is_quick); });
    }
  });
  for (const std::unique_ptr<StemSurface>& surface : surfaces) {
    if (surface == nullptr) continue;
    surface->tubes = results.find<const StemTubes>(surface->key);
    results.count<StemTubes>(surface->tubes != nullptr);
  }
  parallel_for(surfaces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (surfaces[i] == nullptr || surfaces[i]->tubes != nullptr) continue;
      surfaces[i]->plan = plan_stem(plant.stems[i], surfaces[i]->looks, shares[i], is_quick);
    }
  });
  return surfaces;
}

/// The planned stems and organs of a plant.
struct ScenePlan {
  std::vector<std::unique_ptr<StemSurface>> stems;
  OrganDetail organs;
  std::vector<std::size_t> organ_counts;  // number of organs of each prototype

  ScenePlan(const Plant& plant, const MeshDetail& detail, CacheRun& results)
      : ScenePlan(plant, detail, DetailBudget(plant, detail), results) {}

 private:
  ScenePlan(const Plant& plant, const MeshDetail& detail, const DetailBudget& budget, CacheRun& results)
      : stems(plan_stems(plant, budget.of_tubes(detail.level), detail.is_quick, results)),
        organs(plan_organs(plant, detail, budget)),
        organ_counts(organs_of_prototypes(plant, organs)) {}
};

/// Throws InputError if the scene would exceed a limit.
void check_limits(const Plant& plant, const std::vector<MeshInstances>& bodies, const ScenePlan& scene,
                  const SizeLimits& limits) {
  SceneTally tally;
  for (const MeshInstances& body : bodies) tally.add_mesh(body.component, *body.mesh);
  for (const std::unique_ptr<StemSurface>& surface : scene.stems) {
    if (surface != nullptr) tally.add_tubes(surface->looks, surface->sizes());
  }
  for (std::size_t i = 0; i < plant.prototypes.size(); ++i) {
    tally.add_organs(plant.prototypes[i].component, *scene.organs.meshes[i], scene.organ_counts[i]);
  }
  tally.check(limits);
}

/// Returns the tubes of each mesh of a plan, with their first triangles.
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

/// Removes attributes that rays do not need, and frees their memory.
void strip_for_rays(Mesh& mesh, const Material& material) {
  std::vector<Vec3>().swap(mesh.normals);
  if (material.texture == nullptr || !material.texture->masked) std::vector<Vec2>().swap(mesh.uvs);
}

std::shared_ptr<const StemTubes> make_stem(const StemSurface& surface, const std::vector<Material>& materials,
                                           const OwnMeshOptions& options, Progress& progress) {
  auto tubes = std::make_shared<StemTubes>();
  tubes->sizes = surface.plan->sizes();
  tubes->tubes = tubes_of(*surface.plan);
  std::vector<Mesh> meshes = make_stem_tubes(*surface.plan, surface.looks, progress);
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    if (options.detail.work != nullptr) options.detail.work->triangles += meshes[k].triangle_count();
    const Material& material = materials[surface.looks.first_part[k]->material];
    if (options.use == MeshUse::rays) {
      strip_for_rays(meshes[k], material);
    } else if (needs_tangents(material)) {
      add_tangents(meshes[k]);
    }
    tubes->meshes.push_back(std::make_shared<const Mesh>(std::move(meshes[k])));
  }
  return tubes;
}

/// Returns the tubes of each stem.
std::vector<MeshInstances> surface_meshes(const Plant& plant, const std::vector<std::unique_ptr<StemSurface>>& surfaces,
                                          const OwnMeshOptions& options, CacheRun& results, Progress& progress) {
  std::vector<std::uint8_t> is_new(surfaces.size());
  parallel_for(surfaces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      is_new[i] = surfaces[i] != nullptr && surfaces[i]->tubes == nullptr ? 1 : 0;
      if (is_new[i] != 0) {
        surfaces[i]->tubes = make_stem(*surfaces[i], plant.materials, options, progress);
      } else {
        progress.advance(plant.stems[i].skeleton.node_count());
      }
    }
  });
  std::vector<MeshInstances> all;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i] == nullptr) continue;
    const StemSurface& surface = *surfaces[i];
    if (is_new[i] != 0) results.store(surface.key, surface.tubes);
    for (std::size_t k = 0; k < surface.tubes->meshes.size(); ++k) {
      const StemPart& look = *surface.looks.first_part[k];
      MeshInstances& instances = all.emplace_back();
      instances.component = look.component;
      instances.mesh = surface.tubes->meshes[k];
      instances.material = look.material;
      instances.frames = {Frame{}};
      instances.origin = std::make_shared<const MeshOrigin>(
          MeshOrigin{.stem = static_cast<std::uint32_t>(i), .tubes = surface.tubes->tubes[k]});
      if (look.tint != Vec3(1)) instances.tints = {look.tint};
      if (surface.looks.individual[k] != 0) instances.individuals = {surface.looks.individual[k]};
    }
  }
  return all;
}

/// Returns the mesh with the attributes that a material needs.
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

/// Returns a frame that enlarges about the middle `about`. Enlarging about an organ's base would extend the crown's
/// outline by the added length of leaves.
Frame enlarged(float scale, Vec3 about) { return {Mat3(scale), (1 - scale) * about}; }

/// Returns the instances of each prototype, with frames in the order of the organs.
std::vector<MeshInstances> place_organs(const Plant& plant, const ScenePlan& scene, MeshUse use, CacheRun& results,
                                        Progress& progress) {
  std::vector<MeshInstances> placed(plant.prototypes.size());
  std::vector<Vec3> centres(placed.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const OrganPrototype& prototype = plant.prototypes[i];
    if (scene.organ_counts[i] == 0) {
      placed[i] = {prototype.component, scene.organs.meshes[i], prototype.material, {}, {}, {}};
      continue;
    }
    auto mesh = with_cached_tangents(scene.organs.meshes[i], plant.materials[prototype.material], results);
    placed[i] = {prototype.component, std::move(mesh), prototype.material, {}, {}, {}};
    // If some organs are not shown, the frames no longer correspond to all organs in their order.
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
      std::vector<Vec3>().swap(instances.tints);  // also frees its memory
    }
  }
  return placed;
}

/// Returns true if a plant's tubes and organs have few triangles. The number of triangles of its bodies is still
/// unknown.
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

MeshScene clothe(const Plant& plant, const OwnMeshOptions& options, Progress& progress) {
  const auto& [limits, detail, cache, use] = options;
  CacheRun results(cache, {typeid(StemTubes), typeid(BodyMesh), typeid(TangentMesh)});
  if (detail.work != nullptr) ++detail.work->plants;
  const ScenePlan plan(plant, detail, results);
  check_limits(plant, {}, plan, limits);
  std::vector<Material> materials = plant.materials;
  std::vector<MeshInstances> bodies = make_body_meshes(plant, detail, limits, materials, progress, results);
  check_limits(plant, bodies, plan, limits);
  progress.begin("meshing", plant.node_count() + plant.organs.size());
  std::vector<MeshInstances> meshes = surface_meshes(plant, plan.stems, options, results, progress);
  std::move(bodies.begin(), bodies.end(), std::back_inserter(meshes));
  std::vector<MeshInstances> placed = place_organs(plant, plan, use, results, progress);
  std::move(placed.begin(), placed.end(), std::back_inserter(meshes));
  results.end();
  return {std::move(materials), grouped(std::move(meshes)), plant.individuals};
}

}  // namespace

/// Groups meshes by component in the order of first appearance, and removes invisible ones.
std::vector<MeshInstances> grouped(std::vector<MeshInstances> meshes) {
  std::map<std::string, std::size_t> rank;
  for (const MeshInstances& instances : meshes) rank.try_emplace(instances.component, rank.size());
  std::erase_if(meshes, [](const MeshInstances& instances) { return instances.triangle_count() == 0; });
  std::stable_sort(meshes.begin(), meshes.end(), [&rank](const MeshInstances& a, const MeshInstances& b) {
    return rank.at(a.component) < rank.at(b.component);
  });
  return meshes;
}

std::uint64_t planned_triangles(const Plant& plant, const SizeLimits& limits) {
  check_references(plant);
  CacheRun results(nullptr, {});
  const ScenePlan plan(plant, {}, results);
  check_limits(plant, {}, plan, limits);
  std::uint64_t triangles = 0;
  for (const std::unique_ptr<StemSurface>& surface : plan.stems) {
    for (const TubeSize& size : surface->sizes()) triangles += size.triangles;
  }
  for (std::size_t i = 0; i < plant.prototypes.size(); ++i) {
    triangles += plant.prototypes[i].mesh->triangle_count() * plan.organ_counts[i];
  }
  return triangles;
}

MeshScene make_own_meshes(const Plant& plant, const OwnMeshOptions& options, Progress& progress) {
  const MeshDetail& detail = options.detail;
  check_references(plant);
  if (detail.level > 0 && !detail.is_quick && may_be_small(plant)) {
    const MeshScene whole = clothe(plant, {options.limits, MeshDetail(), options.cache}, progress);
    if (whole.triangle_count() <= kSmallPlant) return small_detail(whole, detail, progress);
  }
  return clothe(plant, options, progress);
}

}  // namespace meristem
