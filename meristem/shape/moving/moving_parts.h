// SPDX-License-Identifier: Apache-2.0
// The parts of plants at several times: organs and bodies with mesh, frame and tint, and axes with their tube. Each
// part has one name at all times.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/moving/moving_scene.h"
#include "meristem/shape/moving/moving_tube.h"
#include "meristem/shape/moving/nearest_keys.h"
#include "meristem/shape/stem/stem_looks.h"
#include "meristem/shape/stem/stem_tubes.h"

namespace meristem {

using SharedMesh = std::shared_ptr<const Mesh>;

/// The visible properties that distinguish parts.
struct MovingLook {
  std::uint32_t component = 0;
  std::uint32_t material = 0;
  std::uint32_t individual = 0;
  auto operator<=>(const MovingLook&) const = default;
};

/// A part at one key. The mesh is null if the part does not exist then.
struct PartKey {
  SharedMesh mesh;
  Frame frame;
  Vec3 tint{1};
};

struct MovingPart {
  MovingLook look;  ///< at the last key at which the part exists
  std::vector<PartKey> keys;

  /// Returns, for each key, the nearest key at which the part exists.
  std::vector<std::size_t> nearest() const {
    return nearest_keys(keys.size(), [this](std::size_t key) { return keys[key].mesh != nullptr; });
  }
};

struct AxisTrack {
  MovingLook look;  ///< at the last key at which the axis exists
  /// For each key: null if the axis does not exist, and a shared pointer if the shape equals the shape of another key.
  std::vector<std::shared_ptr<const TubeShape>> shapes;
  std::vector<Vec3> tints;
  std::uint64_t vertices = 0;  ///< largest number of vertices of its shapes
  bool moves = false;          ///< true if the axis has not existed at all keys so far, or has changed

  std::vector<std::size_t> nearest() const {
    return nearest_keys(shapes.size(), [this](std::size_t key) { return shapes[key] != nullptr; });
  }
};

/// Throws InputError if the moving data in this number of keys need more bytes than the limit.
void check_moving_bytes(std::uint64_t bytes, std::size_t keys, const MovingLimits& limits);

/// How the surface of a stem will be made.
struct StemPlan {
  const Stem& stem;
  StemLooks looks;
  TubePlan tubes;

  explicit StemPlan(const Stem& of) : stem(of), looks(of), tubes(plan_stem(of, looks, 1)) {}
};

/// The parts of plants that are added one after another.
class MovingParts {
 public:
  MovingParts(const SizeLimits& limits, const MovingLimits& moving, std::size_t keys)
      : key_count(keys), times(keys), limits_(limits), moving_(moving), is_added_(keys) {}

  /// Like MovingSceneMaker::add.
  void add(std::size_t key, double time, const Plant& plant, Progress& progress);

  /// Returns the tint as a factor on the material's colour in `materials`.
  Vec3 tint_at(const MovingLook& look, Vec3 tint, std::size_t key) const;

  const std::size_t key_count;
  std::vector<double> times;
  std::vector<std::string> components;
  std::vector<Material> materials;
  std::vector<Individual> individuals;
  std::vector<MovingPart> parts;
  std::vector<AxisTrack> axes;

 private:
  std::vector<std::uint32_t> note_materials(const std::vector<Material>& of_plant);
  std::vector<std::uint32_t> note_individuals(const std::vector<Individual>& of_plant);
  std::uint32_t number_of(const std::string& component);
  SharedMesh shared(const SharedMesh& mesh);
  void check_part_keys() const;
  MovingPart& part_of(std::uint64_t name, const MovingLook& look);
  void add_stem(const StemPlan& plan, std::size_t number, const std::vector<std::uint32_t>& materials,
                const std::vector<std::uint32_t>& numbers, Progress& progress);
  void add_shape(std::uint64_t name, const MovingLook& look, Vec3 tint, TubeShape shape);
  void count_motion(AxisTrack& track, bool moves, std::uint64_t vertices);

  const SizeLimits limits_;
  const MovingLimits moving_;
  std::vector<bool> is_added_;  // for each key
  std::size_t now_ = 0;         // the key that is being added
  std::unordered_map<std::string, std::uint32_t> number_of_component_;
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> number_of_material_;  // by name, and number of earlier
                                                                                       // materials with this name
  std::vector<std::vector<std::optional<Vec3>>> colours_;                              // linear, by material and key
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> number_of_individual_;
  std::vector<std::size_t> individual_keys_;                                  // last key at which each individual
                                                                              // exists
  std::unordered_map<std::uint64_t, SharedMesh> meshes_;                      // by hash
  std::unordered_map<const Mesh*, std::pair<SharedMesh, SharedMesh>> known_;  // the given mesh and its shared copy
  std::unordered_map<std::uint64_t, std::size_t> part_by_name_;
  std::unordered_map<std::uint64_t, std::size_t> axis_by_name_;
  std::uint64_t tube_vertices_ = 0;  // vertices of moving axes so far
};

}  // namespace meristem
