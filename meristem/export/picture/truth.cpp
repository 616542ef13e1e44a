// SPDX-License-Identifier: Apache-2.0
// Computes depth, normals and object masks of a picture with one ray per pixel. Rays run in parallel, and objects are
// then numbered in the order of the pixels, so the numbers do not depend on threads.
#include "meristem/export/picture/truth.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/measure/surface_labels.h"
#include "meristem/output/picture/free_side.h"
#include "meristem/output/picture/ground.h"
#include "meristem/output/picture/obstacle_meshes.h"
#include "meristem/output/picture/still.h"
#include "meristem/shape/rays/ray_scene.h"

namespace meristem {

namespace {

constexpr float kSky = std::numeric_limits<float>::infinity();

/// The hit of a pixel's ray: an instance of a part of the plants.
struct Met {
  static constexpr std::uint32_t kNothing = 0xffffffffU;
  std::uint32_t part = kNothing;
  std::uint32_t instance = 0;
  SurfaceLabel label;
};

/// Numbers the visible objects, each once. `Key` identifies an object.
template <class Key>
class Numbers {
 public:
  explicit Numbers(TruthMask& mask) : mask_(mask) {}

  template <class Describe>
  std::uint32_t of(const Key& key, Describe describe) {
    const auto [found, is_new] = numbers_.try_emplace(key, 0);
    if (is_new) {
      mask_.things.push_back(describe());
      found->second = static_cast<std::uint32_t>(mask_.things.size());
    }
    return found->second;
  }

 private:
  TruthMask& mask_;
  std::map<Key, std::uint32_t> numbers_;
};

/// Numbers the visible objects on all levels.
class Census {
 public:
  Census(const MeshScene& meshes, const SurfaceLabels& labels, PictureTruth& truth)
      : meshes_(meshes),
        labels_(labels),
        plants_(truth.masks[static_cast<int>(TruthLevel::plant)]),
        shoots_(truth.masks[static_cast<int>(TruthLevel::shoot)]),
        organs_(truth.masks[static_cast<int>(TruthLevel::organ)]) {}

  /// Writes the numbers of a hit into the masks. Must be called pixel by pixel, in order.
  void add(const Met& met, PictureTruth& truth, std::size_t pixel) {
    const SurfaceLabel& label = met.label;
    const std::optional<PlantKey> key = plant_of(met);
    const std::uint32_t plant =
        !key ? 0 : plants_.of(*key, [&] { return SeenThing{.component = plant_component(*key, met)}; });
    const auto describe_wood = [&] {
      const ShootOrigin origin = labels_.shoot_origin(label.shoot);
      SeenThing thing{.component = origin.component, .order = origin.order};
      thing.plant = plant;
      return thing;
    };
    const bool has_shoot = label.shoot < labels_.shoot_count();
    const std::uint32_t shoot = has_shoot ? shoots_.of(label.shoot, describe_wood) : 0;
    const bool is_organ = label.kind == SurfaceKind::organ || !has_shoot;
    const OrganKey organ_key = is_organ ? OrganKey{1, met.part, met.instance} : OrganKey{0, label.shoot, 0};
    const std::uint32_t organ = organs_.of(organ_key, [&] {
      SeenThing thing =
          is_organ ? SeenThing{.component = labels_.components()[label.component], .is_organ = true} : describe_wood();
      thing.shoot = shoot;
      thing.plant = plant;
      return thing;
    });
    truth.masks[static_cast<int>(TruthLevel::organ)].number[pixel] = organ;
    truth.masks[static_cast<int>(TruthLevel::shoot)].number[pixel] = shoot;
    truth.masks[static_cast<int>(TruthLevel::plant)].number[pixel] = plant;
  }

 private:
  /// What identifies a plant: an individual, a tree of a plant that stands in several places, or the place itself.
  enum class PlantBy { individual, tree, place };
  using PlantKey = std::tuple<PlantBy, std::uint32_t, std::uint32_t>;
  using OrganKey = std::tuple<int, std::uint32_t, std::uint32_t>;

  std::optional<PlantKey> plant_of(const Met& met) const {
    const MeshInstances& part = meshes_.meshes[met.part];
    if (part.places == nullptr) {
      const std::uint32_t individual = part.individual(met.instance);
      if (individual == kNoIndividual) return std::nullopt;
      return PlantKey{PlantBy::individual, individual, 0};
    }
    if (met.label.tree != kNoTree) return PlantKey{PlantBy::tree, met.label.tree, 0};
    const std::uint32_t planting = part.origin != nullptr ? part.origin->planting : met.part;
    return PlantKey{PlantBy::place, planting, static_cast<std::uint32_t>(met.instance / part.frames.size())};
  }

  std::string plant_component(const PlantKey& key, const Met& met) const {
    const std::uint32_t number = std::get<1>(key);
    if (std::get<0>(key) == PlantBy::individual && number < meshes_.individuals.size()) {
      return meshes_.individuals[number].component;
    }
    // The component of a placed plant begins with the id of its placing component: "oak.leaf".
    const std::string& component = meshes_.meshes[met.part].component;
    return component.substr(0, component.find('.'));
  }

  const MeshScene& meshes_;
  const SurfaceLabels& labels_;
  Numbers<PlantKey> plants_;
  Numbers<std::uint32_t> shoots_;
  Numbers<OrganKey> organs_;
};

}  // namespace

PictureTruth see_truth(const GrownDocument& grown, const SizeLimits& limits, const Scene& scene, const CameraView& view,
                       const TruthOptions& options, Progress& progress) {
  check_still_options({.width = options.width, .height = options.height});
  // Use the scene and the camera of the picture.
  const bool shows_obstacles = !options.transparent && has_visible(scene.obstacles);
  const MeshScene meshes_around = shows_obstacles ? with_obstacles(grown.meshes, scene.obstacles) : MeshScene();
  const MeshScene& shown = shows_obstacles ? meshes_around : grown.meshes;
  const MeshScene& framed = grown.meshes.meshes.empty() ? shown : grown.meshes;
  const RayScene rays(shown, progress);
  const double aspect = static_cast<double>(options.width) / options.height;
  const CameraView seen =
      shows_obstacles ? view_past_obstacles(grown.meshes, scene.obstacles, view, aspect, progress) : view;
  const Camera camera = place_camera(framed, seen, aspect);
  const std::size_t pixels = std::size_t{1} * options.width * options.height;
  PictureTruth truth{.width = options.width,
                     .height = options.height,
                     .depth = std::vector<float>(pixels, kSky),
                     .normal = std::vector<Vec3>(pixels, Vec3(0)),
                     .masks = {},
                     .camera = camera};
  for (TruthMask& mask : truth.masks) mask.number.assign(pixels, 0);
  const Ground ground = ground_below(framed, scene);
  const SurfaceLabels labels(grown.plant, limits, shown, progress);
  Census census(shown, labels, truth);

  // Find the surface of each pixel.
  progress.begin("looking", options.height);
  std::vector<Met> met(pixels);
  parallel_for(static_cast<std::size_t>(options.height), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) {
      progress.advance();
      for (int x = 0; x < options.width; ++x) {
        const Vec2 film(2 * (static_cast<float>(x) + 0.5F) / static_cast<float>(options.width) - 1,
                        1 - 2 * (static_cast<float>(y) + 0.5F) / static_cast<float>(options.height));
        const Ray ray{camera.position(), camera.direction(film)};
        const std::size_t pixel = y * options.width + x;
        const std::optional<RayHit> hit = rays.first_hit(ray);
        const float to_ground = (ground.height - ray.origin.y) / ray.direction.y;
        const bool meets_ground = !options.transparent && ray.direction.y != 0 && to_ground > 0;
        Vec3 normal(0, ray.origin.y >= ground.height ? 1 : -1, 0);
        float distance = meets_ground ? to_ground : kSky;
        if (hit && hit->distance < distance) {
          distance = hit->distance;
          const SurfacePoint point = rays.surface_point(*hit);
          normal = glm::dot(point.normal, ray.direction) > 0 ? -point.normal : point.normal;
          const SurfaceLabel label = labels.of(hit->part, hit->instance, hit->triangle, point.position);
          const bool is_plant = label.kind == SurfaceKind::wood || label.kind == SurfaceKind::organ;
          if (is_plant) met[pixel] = {hit->part, hit->instance, label};
        }
        if (distance == kSky) continue;
        truth.depth[pixel] = distance * glm::dot(ray.direction, camera.forward());
        truth.normal[pixel] =
            Vec3(glm::dot(normal, camera.right()), glm::dot(normal, camera.up()), -glm::dot(normal, camera.forward()));
      }
    }
  });

  // Number objects in the order of the pixels, so that the numbers do not depend on threads.
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    if (met[pixel].part != Met::kNothing) census.add(met[pixel], truth, pixel);
  }
  return truth;
}

}  // namespace meristem
