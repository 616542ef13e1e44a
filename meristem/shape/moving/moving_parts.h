// SPDX-License-Identifier: Apache-2.0
// What the parts of plants are at some times: organs and bodies with mesh, frame and tint, axes with their tube, each
// by the name that it has at all of them.
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
#include "meristem/shape/stem_looks.h"
#include "meristem/shape/stem_tubes.h"

namespace meristem {

using SharedMesh = std::shared_ptr<const Mesh>;

/// What tells parts apart to the eye.
struct MovingLook {
  std::uint32_t component = 0;
  std::uint32_t material = 0;
  std::uint32_t individual = 0;
  auto operator<=>(const MovingLook&) const = default;
};

/// A part at one key; no mesh where it is not there.
struct PartKey {
  SharedMesh mesh;
  Frame frame;
  Vec3 tint{1};
};

struct MovingPart {
  MovingLook look;  ///< at the last key at which it is there
  std::vector<PartKey> keys;

  /// By key: the nearest one at which it is there.
  std::vector<std::size_t> nearest() const {
    return nearest_keys(keys.size(), [this](std::size_t key) { return keys[key].mesh != nullptr; });
  }
};

struct AxisTrack {
  MovingLook look;  ///< at the last key at which it is there
  /// By key: null where it is not there, and the same one where it is as at another key.
  std::vector<std::shared_ptr<const TubeShape>> shapes;
  std::vector<Vec3> tints;
  std::uint64_t vertices = 0;  ///< of the fullest shape
  bool moves = false;          ///< it is not there at all keys so far, or not the same

  std::vector<std::size_t> nearest() const {
    return nearest_keys(shapes.size(), [this](std::size_t key) { return shapes[key] != nullptr; });
  }
};

/// Throws InputError where what moves in this number of keys takes more bytes than it may.
void check_moving_bytes(std::uint64_t bytes, std::size_t keys, const MovingLimits& limits);

/// How a stem will be clothed.
struct StemPlan {
  const Stem& stem;
  StemLooks looks;
  TubePlan tubes;

  explicit StemPlan(const Stem& of) : stem(of), looks(of), tubes(plan_stem(of, looks, 1)) {}
};

/// The parts of plants that are added one after another.
class MovingParts {
 public:
  MovingParts(const Limits& limits, const MovingLimits& moving, std::size_t keys)
      : key_count(keys), times(keys), limits_(limits), moving_(moving), is_added_(keys) {}

  /// As MovingSceneMaker::add.
  void add(std::size_t key, double time, const Plant& plant, Progress& progress);

  /// The tint as a factor on the colour that the material has in `materials`.
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

  const Limits limits_;
  const MovingLimits moving_;
  std::vector<bool> is_added_;  // by key
  std::size_t now_ = 0;         // the key that is added
  std::unordered_map<std::string, std::uint32_t> number_of_component_;
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> number_of_material_;  // by name and how many before it
  std::vector<std::vector<std::optional<Vec3>>> colours_;                              // linear, by material and key
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> number_of_individual_;
  std::vector<std::size_t> individual_keys_;                                  // the last at which each is there
  std::unordered_map<std::uint64_t, SharedMesh> meshes_;                      // by their hash
  std::unordered_map<const Mesh*, std::pair<SharedMesh, SharedMesh>> known_;  // as they were given, and are shared
  std::unordered_map<std::uint64_t, std::size_t> part_by_name_;
  std::unordered_map<std::uint64_t, std::size_t> axis_by_name_;
  std::uint64_t tube_vertices_ = 0;  // of axes that move, so far
};

}  // namespace meristem
