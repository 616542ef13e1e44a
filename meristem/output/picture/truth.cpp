// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/picture/truth.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/output/picture/ground.h"
#include "meristem/output/picture/obstacle_meshes.h"
#include "meristem/output/picture/still.h"
#include "meristem/plant/nearest_axis.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/ray_scene.h"

namespace meristem {

namespace {

constexpr float kSky = std::numeric_limits<float>::infinity();

/// What a pixel's ray has met: an instance of a part of the plants, and of wood its axis as well.
struct Met {
  static constexpr std::uint32_t kNothing = 0xffffffffU;
  std::uint32_t part = kNothing;
  std::uint32_t instance = 0;
  StemAxis axis{kNoStem, 0};
};

/// Numbers what is seen, each thing once. `Key` says which thing it is.
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

/// Who is who among the meshes of a plant.
class Census {
 public:
  Census(const MeshScene& meshes, const Plant& plant, Truth& truth)
      : meshes_(meshes),
        plant_(plant),
        nearest_(plant),
        plants_(truth.masks[static_cast<int>(TruthLevel::plant)]),
        shoots_(truth.masks[static_cast<int>(TruthLevel::shoot)]),
        organs_(truth.masks[static_cast<int>(TruthLevel::organ)]) {
    std::set<std::string_view> stem_components;
    for (const Stem& stem : plant.stems) {
      for (const StemPart& part : stem.parts) stem_components.insert(part.component);
      individuals_.push_back(stem.individual_of_axis());
      std::vector<int>& orders = orders_.emplace_back(individuals_.back().size(), 0);
      for (NodeIndex node = stem.skeleton.node_count(); node-- > 0;) {
        orders[stem.skeleton.axis[node]] = stem.skeleton.order[node];
      }
    }
    // Wood stands in the world as it is; organs are placed.
    for (const MeshInstances& part : meshes.meshes) {
      is_wood_.push_back(part.frames.size() == 1 && part.frames[0].axes == Mat3(1) &&
                         part.frames[0].origin == Vec3(0) && stem_components.contains(part.component));
    }
  }

  bool is_wood(std::uint32_t part) const { return is_wood_[part]; }
  StemAxis axis_at(Vec3 position) const { return nearest_.find(position).value_or(StemAxis{kNoStem, 0}); }

  /// Writes the numbers of what was met into the masks. To be called pixel by pixel, in order.
  void add(const Met& met, Truth& truth, std::size_t pixel) {
    const bool wood = met.axis.stem != kNoStem;
    const StemAxis axis = wood ? met.axis : axis_of_organ(met);
    const std::uint32_t individual = individual_of(met, axis, wood);
    const std::uint32_t plant = individual == kNoIndividual ? 0 : plants_.of(individual, [&] {
      return SeenThing{.component = individual < plant_.individuals.size() ? plant_.individuals[individual].component
                                                                           : meshes_.meshes[met.part].component};
    });
    const auto describe_wood = [&] {
      return SeenThing{.component = plant_.stems[axis.stem].part(axis.axis).component,
                       .plant = plant,
                       .order = orders_[axis.stem][axis.axis]};
    };
    const std::uint32_t shoot = axis.stem == kNoStem ? 0 : shoots_.of(axis, describe_wood);
    const std::uint32_t organ =
        wood ? organs_.of({0, axis.stem, axis.axis},
                          [&] {
                            SeenThing thing = describe_wood();
                            thing.shoot = shoot;
                            return thing;
                          })
             : organs_.of({1, met.part, met.instance}, [&] {
                 return SeenThing{
                     .component = meshes_.meshes[met.part].component, .is_organ = true, .shoot = shoot, .plant = plant};
               });
    truth.masks[static_cast<int>(TruthLevel::organ)].number[pixel] = organ;
    truth.masks[static_cast<int>(TruthLevel::shoot)].number[pixel] = shoot;
    truth.masks[static_cast<int>(TruthLevel::plant)].number[pixel] = plant;
  }

 private:
  StemAxis axis_of_organ(const Met& met) {
    const auto [found, is_new] = axes_of_organs_.try_emplace({met.part, met.instance});
    if (is_new) {
      const Vec3 base = meshes_.meshes[met.part].frame(met.instance).origin;
      found->second = nearest_.find_bearer(base).value_or(StemAxis{kNoStem, 0});
    }
    return found->second;
  }

  std::uint32_t individual_of(const Met& met, StemAxis axis, bool wood) const {
    if (wood) return individuals_[axis.stem][axis.axis];
    const MeshInstances& part = meshes_.meshes[met.part];
    // Where a plant stands in several places, the organ's shoot knows which one it is.
    if (part.places != nullptr && axis.stem != kNoStem) return individuals_[axis.stem][axis.axis];
    return part.individual(met.instance);
  }

  const MeshScene& meshes_;
  const Plant& plant_;
  const NearestAxis nearest_;
  std::vector<bool> is_wood_;
  std::vector<std::vector<std::uint32_t>> individuals_;  // of each axis of each stem
  std::vector<std::vector<int>> orders_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, StemAxis> axes_of_organs_;
  Numbers<std::uint32_t> plants_;
  Numbers<StemAxis> shoots_;
  Numbers<std::tuple<int, std::uint32_t, std::uint32_t>> organs_;
};

Camera camera_over(const MeshScene& framed, const View& view, const TruthOptions& options) {
  return place_camera(framed, view, static_cast<double>(options.width) / options.height);
}

}  // namespace

Camera truth_camera(const GrownDocument& grown, const Scene& scene, const View& view, const TruthOptions& options) {
  const bool shows_obstacles = grown.meshes.meshes.empty() && !options.transparent && has_visible(scene.obstacles);
  return camera_over(shows_obstacles ? with_obstacles(grown.meshes, scene.obstacles) : grown.meshes, view, options);
}

Truth see_truth(const GrownDocument& grown, const Scene& scene, const View& view, const TruthOptions& options,
                Progress& progress) {
  check_still_options({.width = options.width, .height = options.height});
  const std::size_t pixels = std::size_t{1} * options.width * options.height;
  Truth truth{.width = options.width,
              .height = options.height,
              .depth = std::vector<float>(pixels, kSky),
              .normal = std::vector<Vec3>(pixels, Vec3(0)),
              .masks = {}};
  for (TruthMask& mask : truth.masks) mask.number.assign(pixels, 0);
  progress.begin("looking", options.height);

  // The scene and the camera are those of the picture.
  const bool shows_obstacles = !options.transparent && has_visible(scene.obstacles);
  const MeshScene meshes_around = shows_obstacles ? with_obstacles(grown.meshes, scene.obstacles) : MeshScene();
  const MeshScene& shown = shows_obstacles ? meshes_around : grown.meshes;
  const MeshScene& framed = grown.meshes.meshes.empty() ? shown : grown.meshes;
  const auto plant_parts = static_cast<std::uint32_t>(grown.meshes.meshes.size());
  const RayScene rays(shown, progress);
  const Camera camera = camera_over(framed, view, options);
  const Ground ground = ground_below(framed, scene);
  const ExpandedPlant plant(grown.plant, progress);
  Census census(grown.meshes, *plant, truth);

  // Each pixel's surface.
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
          if (hit->part < plant_parts) {
            met[pixel] = {hit->part, hit->instance};
            if (census.is_wood(hit->part)) met[pixel].axis = census.axis_at(point.position);
          }
        }
        if (distance == kSky) continue;
        truth.depth[pixel] = distance * glm::dot(ray.direction, camera.forward());
        truth.normal[pixel] =
            Vec3(glm::dot(normal, camera.right()), glm::dot(normal, camera.up()), -glm::dot(normal, camera.forward()));
      }
    }
  });

  // What is seen is numbered in the order of the pixels, so that the numbers depend on no thread.
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    if (met[pixel].part != Met::kNothing) census.add(met[pixel], truth, pixel);
  }
  return truth;
}

}  // namespace meristem
