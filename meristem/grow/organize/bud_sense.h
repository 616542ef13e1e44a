// SPDX-License-Identifier: Apache-2.0
// The perception of the buds of a tree: the light that the shade of all plants leaves, or the free space that markers
// show. Obstacles and lamps of the scene affect both.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/grow/metamer/metamers.h"
#include "meristem/grow/metamer/resource.h"
#include "meristem/grow/organize/species.h"
#include "meristem/grow/stand_space.h"

namespace meristem {

/// The light of the scene at the metamers of a tree, reduced by obstacles: 1 without any shade.
class SceneLight {
 public:
  SceneLight(const Scene& scene, Vec3 root);
  float at(MetamerIndex metamer) const { return is_even_ ? 1 : light_[metamer]; }
  /// Returns the light at a position in world space.
  float reaching(Vec3 position) const;

  /// Update the light after Metamers::grow(), after a move, and after Metamers::remove().
  void add(Vec3 position);
  void move(MetamerIndex metamer, Vec3 position);
  void remove(const std::vector<std::uint8_t>& gone);
  /// Restores the state of a copy.
  void restore(SceneLight copy) { light_ = std::move(copy.light_); }

 private:
  const Scene& scene_;
  bool is_even_;
  std::vector<float> light_;  // by metamer
};

class BudSense {
 public:
  virtual ~BudSense() = default;
  /// Computes the light of all competing buds from the current state of the stand's space.
  virtual void sense(BudLight& light, const Progress& progress) = 0;
  /// Returns the unit vector in which a bud finds more light or space, or 0 if no direction is better. Valid after
  /// sense(). Thread-safe if each thread has its own `recent`.
  virtual Vec3 way(MetamerIndex metamer, bool is_lateral, ShadowGrid::Recent& recent) const = 0;
  /// Returns true if buds at a position in world space can perceive anything. Positions too far from the world's origin
  /// cannot.
  virtual bool reaches(Vec3 position) const = 0;
  /// Makes the buds search again in the next round of the stand.
  virtual void look_again() {}
  /// The volume and field of markers that the buds use; null if they do not use markers.
  struct OwnRoom {
    const MarkerField* field = nullptr;
    std::uint32_t volume = 0;
  };
  virtual OwnRoom room() const { return {}; }
};

/// Makes the perception of one tree's buds. `metamers` and `light` of the tree must outlive it. Call it before the
/// first round.
std::unique_ptr<BudSense> make_bud_sense(const OrganizedSpecies& species, StandSpace& space, const OrganizeSeed& seed,
                                         RandomKey key, const Metamers& metamers, const SceneLight& light);

}  // namespace meristem
