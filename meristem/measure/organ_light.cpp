// SPDX-License-Identifier: Apache-2.0
// In:  a plant with its meshes, and the scene around it. Out: for each organ the share of the scene's light that
// arrives.
//
// From evenly spread points on an organ's surface, a ray goes toward every light. The ray starts just off the surface,
// on the side that faces the light. Everything that is visible in a picture stops it. Light that leaves transmit or
// reflect is not followed.
#include "meristem/measure/organ_light.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "meristem/base/parallel.h"
#include "meristem/measure/block_light.h"
#include "meristem/measure/foliage.h"
#include "meristem/measure/masked_surfaces.h"
#include "meristem/measure/surface_points.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/rays/ray_scene.h"
#include "meristem/shape/texture/alpha_mask.h"

namespace meristem {
namespace {

constexpr double kAreaOfPlace = 0.001;  // area per sample, square metres
constexpr int kMinPlaces = 4;
constexpr int kMaxPlaces = 64;
constexpr int kTrials = 16;  // most attempts to find a position that is not in a hole
constexpr std::size_t kRaysPerBlock = 4096;

using Point = SurfacePoints::Point;

/// The surface that all organs of a prototype share.
class OrganSurface {
 public:
  OrganSurface(const Mesh& mesh, const AlphaMask* mask)
      : mesh_(mesh), places_(mesh, mesh.stalk_triangles), mask_(mask) {}

  bool is_empty() const { return !(places_.area() > 0); }

  /// Returns the position at `along` and `across`, or a later position that is not in a hole.
  Point solid_place(double along, double across) const {
    Point place = places_.at(along, across);
    for (int trial = 1; trial < kTrials && is_hole(place); ++trial) {
      place = places_.at(fraction(along + trial * kSquareSteps[0]), fraction(across + trial * kSquareSteps[1]));
    }
    return place;
  }

  Vec3 position(const Point& place) const { return places_.position(place); }

  /// Returns the normal of the triangle at a position under a frame, or (0, 0, 0) if the frame flattens the triangle to
  /// a line.
  Vec3 face_normal(const Point& place, const Frame& frame) const {
    const auto [a, b, c] = mesh_.triangles[place.triangle];
    const Vec3 to_b = frame.vector(mesh_.positions[b] - mesh_.positions[a]);
    const Vec3 to_c = frame.vector(mesh_.positions[c] - mesh_.positions[a]);
    return normalized_or(glm::cross(to_b, to_c), Vec3(0));
  }

 private:
  bool is_hole(const Point& place) const {
    if (mask_ == nullptr) return false;
    const auto [a, b, c] = mesh_.triangles[place.triangle];
    return mask_->is_hole(place.weights.x * mesh_.uvs[a] + place.weights.y * mesh_.uvs[b] +
                          place.weights.z * mesh_.uvs[c]);
  }

  const Mesh& mesh_;
  SurfacePoints places_;
  const AlphaMask* mask_;  // null if the surface has no holes
};

/// The surfaces of all prototypes, with the masks of their textures.
class OrganSurfaces {
 public:
  /// Finds the surfaces of the prototypes that `block` has and earlier blocks did not have.
  void add_new(const Plant& block) {
    for (std::size_t k = surfaces_.size(); k < block.prototypes.size(); ++k) {
      const OrganPrototype& prototype = block.prototypes[k];
      const Texture* texture = texture_with_holes(block.materials[prototype.material], *prototype.mesh);
      const AlphaMask* mask = nullptr;
      if (texture != nullptr) mask = &masks_.try_emplace(texture, texture->colour).first->second;
      surfaces_.emplace_back(*prototype.mesh, mask);
    }
  }
  const OrganSurface& of(const Organ& organ) const { return surfaces_[organ.prototype]; }

 private:
  std::map<const Texture*, AlphaMask> masks_;
  std::vector<OrganSurface> surfaces_;
};

/// Sums of the strengths of the rays from some positions.
struct LightSum {
  double sent = 0;
  double arrived = 0;
  double taken_up = 0;
};

/// All surfaces that can stop rays between lights and organs.
class Shade {
 public:
  Shade(const MeshScene& meshes, const Scene& scene, Progress& progress) : scene_(scene), plant_(meshes, progress) {}

  void add_place(Vec3 position, Vec3 normal, LightSum& sum) const {
    const float clearance = RayScene::clearance(position);
    scene_.light.for_each_ray(position, [&](const LightRay& light) {
      if (!(light.strength > 0)) return;
      sum.sent += light.strength;
      const float cosine = glm::dot(normal, light.toward);
      const Vec3 start = position + (cosine < 0 ? -clearance : clearance) * normal;
      if (is_blocked(start, light)) return;
      sum.arrived += light.strength;
      sum.taken_up += light.strength * std::abs(double{cosine});
    });
  }

 private:
  bool is_blocked(Vec3 start, const LightRay& light) const {
    return plant_.is_blocked({start, light.toward}, static_cast<float>(light.distance)) ||
           scene_.obstacles.block(start, light.toward, light.distance);
  }

  const Scene& scene_;
  RayScene plant_;
};

int place_count(double area) {
  const double wanted = std::ceil(area / kAreaOfPlace);
  return static_cast<int>(std::clamp(wanted, double{kMinPlaces}, double{kMaxPlaces}));
}

/// Returns the light on organ number `index`. Organs of one prototype are sampled at different positions.
LightSum light_on(const Organ& organ, const OrganSurface& surface, int places, std::size_t index, const Shade& shade,
                  const Progress& progress) {
  LightSum sum;
  const double first = fraction(0.5 + static_cast<double>(index) * kSquareSteps[0]);
  const double start = fraction(static_cast<double>(index) * kSquareSteps[1]);
  for (int k = 0; k < places; ++k) {
    progress.check();
    const Point place = surface.solid_place((k + first) / places, fraction(start + k * kGoldenStep));
    const Vec3 normal = surface.face_normal(place, organ.frame);
    if (normal != Vec3(0)) shade.add_place(organ.frame.point(surface.position(place)), normal, sum);
  }
  return sum;
}

}  // namespace

struct BlockLight::Parts {
  Parts(const MeshScene& meshes, const Scene& scene, Progress& progress) : shade(meshes, scene, progress) {
    const Light& light = scene.light;
    const std::size_t rays = kMinPlaces * (light.sun.size() + light.sky.size() + light.lamps.size());
    grain = std::max<std::size_t>(1, kRaysPerBlock / std::max<std::size_t>(rays, 1));
  }

  Shade shade;
  OrganSurfaces surfaces;
  std::size_t grain = 1;   // organs of one task
  std::size_t organs = 0;  // organs of earlier blocks
};

BlockLight::BlockLight(const MeshScene& meshes, const Scene& scene, Progress& progress)
    : parts_(std::make_unique<Parts>(meshes, scene, progress)) {}

BlockLight::~BlockLight() = default;

std::vector<LitOrgan> BlockLight::measure(const Plant& block, std::span<const OrganArea> areas, Progress& progress) {
  Parts& parts = *parts_;
  parts.surfaces.add_new(block);
  std::vector<LitOrgan> lit(areas.size());
  parallel_for(areas.size(), parts.grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      lit[k].area = areas[k].blade;
      const Organ& organ = block.organs[k];
      const OrganSurface& surface = parts.surfaces.of(organ);
      if (surface.is_empty()) continue;
      const LightSum sum =
          light_on(organ, surface, place_count(areas[k].blade), parts.organs + k, parts.shade, progress);
      if (!(sum.sent > 0)) continue;
      lit[k].exposure = sum.arrived / sum.sent;
      lit[k].irradiance = sum.taken_up / sum.sent;
    }
    progress.advance(end - begin);
  });
  parts.organs += block.organs.size();
  return lit;
}

std::vector<LitOrgan> measure_organ_light(const Plant& plant, const SizeLimits& limits, const MeshScene& meshes,
                                          const Scene& scene, Progress& progress) {
  const std::uint64_t organs = totals_of(plant).organs;
  progress.begin("measuring light", organs);
  std::vector<LitOrgan> lit;
  if (organs == 0) return lit;
  std::optional<BlockLight> light;  // created after the limits were checked
  MaskedSurfaces surfaces;
  expand_in_blocks(plant, limits, progress, [&](const Plant& block) {
    if (!light) light.emplace(meshes, scene, progress);
    surfaces.add_new(block);
    Progress silent(&progress);
    const std::vector<LitOrgan> of_block = light->measure(block, surfaces.areas(block, silent), progress);
    lit.insert(lit.end(), of_block.begin(), of_block.end());
  });
  return lit;
}

LitOrgan mean_leaf_light(const Plant& plant, const std::vector<LitOrgan>& organs) {
  MeanLight light;
  for (std::size_t k = 0; k < organs.size(); ++k) {
    if (is_leaf(plant, plant.organs[k])) light.add(organs[k]);
  }
  return light.mean();
}

}  // namespace meristem
