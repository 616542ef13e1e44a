// SPDX-License-Identifier: Apache-2.0
// Counts the geometry of a plant without making its tubes. A placed plant is counted once and multiplied by its places.
#include "meristem/shape/assembly/geometry_count.h"

#include <cstddef>
#include <exception>
#include <optional>
#include <unordered_map>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/frame.h"
#include "meristem/base/parallel.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/mesh/tangents.h"
#include "meristem/shape/stem/body_meshes.h"
#include "meristem/shape/stem/cached_meshes.h"
#include "meristem/shape/stem/stem_looks.h"
#include "meristem/shape/stem/stem_tubes.h"
#include "meristem/shape/tube/tube_plan.h"

namespace meristem {
namespace {

/// The geometry of the parts that show a plant in its own coordinates.
struct PartSums {
  GeometryCount geometry;
  std::uint64_t parts = 0;  // a part within placed plants counts once for each place

  void add(std::uint64_t triangles, std::uint64_t mesh_bytes, std::uint64_t frames) {
    if (triangles * frames == 0) return;  // such a part is left out
    geometry.triangles += triangles * frames;
    geometry.instances += frames;
    geometry.bytes += mesh_bytes + frames * sizeof(Frame);
    ++parts;
  }
  void add_placed(const PartSums& plant, std::uint64_t places) {
    if (places == 0) return;
    geometry.triangles += places * plant.geometry.triangles;
    geometry.instances += places * plant.geometry.instances;
    geometry.bytes += plant.geometry.bytes;
    parts += places * plant.parts;
  }
};

std::uint64_t tangent_bytes(std::uint64_t vertices, const Material& material) {
  return needs_tangents(material) ? vertices * sizeof(Vec4) : 0;
}

std::uint64_t bytes_with_tangents(const Mesh& mesh, const Material& material) {
  const bool can_have = mesh.tangents.empty() && !mesh.normals.empty() && !mesh.uvs.empty();
  return mesh.bytes() + (can_have ? tangent_bytes(mesh.vertex_count(), material) : 0);
}

PartSums sums_of_tubes(const Stem& stem, const std::vector<Material>& materials) {
  const StemLooks looks(stem);
  const TubePlan plan = plan_stem(stem, looks, 1, false);
  PartSums sums;
  for (std::size_t k = 0; k < plan.sizes().size(); ++k) {
    const TubeSize& size = plan.sizes()[k];
    const Material& material = materials[looks.first_part[k]->material];
    sums.add(size.triangles, size.bytes() + tangent_bytes(size.vertices, material), 1);
  }
  return sums;
}

/// Returns the sums of a plant without its plantings.
PartSums sums_of(const Plant& plant, const SizeLimits& limits, Progress& progress) {
  std::vector<PartSums> of_stem(plant.stems.size());
  parallel_for(of_stem.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      progress.check();
      of_stem[k] = sums_of_tubes(plant.stems[k], plant.materials);
    }
  });
  PartSums sums;
  for (const PartSums& one : of_stem) sums.add_placed(one, 1);
  std::vector<Material> materials = plant.materials;
  CacheRun results(nullptr, {});
  for (const MeshInstances& body : make_body_meshes(plant, {}, limits, materials, progress, results)) {
    sums.add(body.mesh->triangle_count(), body.mesh->bytes(), 1);
  }
  std::vector<std::uint64_t> organs(plant.prototypes.size());
  for (const Organ& organ : plant.organs) ++organs[organ.prototype];
  for (std::size_t k = 0; k < organs.size(); ++k) {
    const OrganPrototype& prototype = plant.prototypes[k];
    sums.add(prototype.mesh->triangle_count(),
             bytes_with_tangents(*prototype.mesh, plant.materials[prototype.material]), organs[k]);
  }
  return sums;
}

/// Like sums_of, with copies of the deformed plantings.
PartSums sums_with_copies(const Plant& plant, const SizeLimits& limits, Progress& progress) {
  if (!has_deformed_plantings(plant)) return sums_of(plant, limits, progress);
  return sums_of(with_deformed_copies(plant, limits, progress), limits, progress);
}

/// Counts a plant and all plants that stand in it.
class PlantCounter {
 public:
  explicit PlantCounter(const Plant& plant) { gather(plant); }

  GeometryCount run(const SizeLimits& limits, Progress& progress) {
    count_each(limits, progress);
    const Plant& whole = *plants_.front();
    GeometryCount count = own_.front().geometry;
    for (const Planting& planting : whole.plantings) {
      if (planting.deformation != nullptr || planting.places.empty()) continue;
      const PartSums& plant = total_of(*planting.variant->plant);
      const std::uint64_t places = planting.places.size();
      count.triangles += places * plant.geometry.triangles;
      count.instances += places * plant.geometry.instances;
      count.bytes += plant.geometry.bytes + places * plant.parts * sizeof(Frame);
    }
    return count;
  }

 private:
  void gather(const Plant& plant) {
    if (!number_.try_emplace(&plant, plants_.size()).second) return;
    plants_.push_back(&plant);
    for (const Planting& planting : plant.plantings) {
      if (planting.deformation == nullptr) gather(*planting.variant->plant);
    }
  }

  /// Counts in parallel. If several counts fail, the choice of the thrown error does not depend on threads.
  void count_each(const SizeLimits& limits, Progress& progress) {
    own_.resize(plants_.size());
    totals_.resize(plants_.size());
    std::vector<std::exception_ptr> errors(plants_.size());
    progress.begin("counting triangles", plants_.size());
    parallel_for(plants_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        Progress silent(&progress);
        try {
          own_[k] = sums_with_copies(*plants_[k], limits, silent);
        } catch (const InputError&) {
          errors[k] = std::current_exception();
        }
        progress.advance();
      }
    });
    for (const std::exception_ptr& error : errors) {
      if (error) std::rethrow_exception(error);
    }
  }

  /// Returns the sums of a placed plant with everything that stands in it. The readers of documents limit the depth.
  const PartSums& total_of(const Plant& plant) {
    const std::size_t number = number_.at(&plant);
    if (totals_[number]) return *totals_[number];
    PartSums total = own_[number];
    for (const Planting& planting : plant.plantings) {
      if (planting.deformation == nullptr) total.add_placed(total_of(*planting.variant->plant), planting.places.size());
    }
    totals_[number] = total;
    return *totals_[number];
  }

  std::vector<const Plant*> plants_;
  std::unordered_map<const Plant*, std::size_t> number_;
  std::vector<PartSums> own_;  // without plantings
  std::vector<std::optional<PartSums>> totals_;
};

}  // namespace

GeometryCount count_geometry(const MeshScene& scene) {
  GeometryCount count{scene.triangle_count(), scene.instance_count(), 0};
  for (const MeshInstances& part : scene.meshes) {
    const std::size_t places = part.places == nullptr ? 0 : part.places->size();
    count.bytes += part.mesh->bytes() + (part.frames.size() + places) * sizeof(Frame);
  }
  return count;
}

GeometryCount count_geometry(const Plant& plant, const SizeLimits& limits, Progress& progress) {
  return PlantCounter(plant).run(limits, progress);
}

}  // namespace meristem
