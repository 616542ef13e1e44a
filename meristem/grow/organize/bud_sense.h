// SPDX-License-Identifier: Apache-2.0
// How the buds of a tree perceive what they compete for: the light that the shade of all plants leaves, or the room
// that markers show. Obstacles and lamps of the scene change either.
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

/// The light of the scene that reaches the metamers of a tree past its obstacles: 1 in the open.
class SceneLight {
 public:
  SceneLight(const Scene& scene, Vec3 root);
  float at(MetamerIndex metamer) const { return is_even_ ? 1 : light_[metamer]; }
  /// At a position in world space.
  float reaching(Vec3 position) const;

  /// Follow Metamers::grow(), what moves, and Metamers::remove().
  void add(Vec3 position);
  void move(MetamerIndex metamer, Vec3 position);
  void remove(const std::vector<std::uint8_t>& gone);
  /// Makes it what a copy of it holds.
  void restore(SceneLight copy) { light_ = std::move(copy.light_); }

 private:
  const Scene& scene_;
  bool is_even_;
  std::vector<float> light_;  // by metamer
};

class BudSense {
 public:
  virtual ~BudSense() = default;
  /// The light of all buds that compete, as the stand's space is now.
  virtual void sense(BudLight& light, const Progress& progress) = 0;
  /// The unit vector in which a bud finds more of it, after sense(); 0 where that is no way in particular. From many
  /// threads at once, each with a `recent` of its own.
  virtual Vec3 way(MetamerIndex metamer, bool is_lateral, ShadowGrid::Recent& recent) const = 0;
  /// Whether buds at a position in world space can perceive anything; if not, it is too far from the world's origin.
  virtual bool reaches(Vec3 position) const = 0;
  /// Has the buds look in the stand's next round, whichever one that is.
  virtual void look_again() {}
  /// The room that buds look for: a volume of a field of markers; null where they look for something else.
  struct OwnRoom {
    const MarkerField* field = nullptr;
    std::uint32_t volume = 0;
  };
  virtual OwnRoom room() const { return {}; }
};

/// The sense of one tree's buds; the tree's `metamers` and `light` outlive it. To be called before the first round.
std::unique_ptr<BudSense> make_bud_sense(const OrganizedSpecies& species, StandSpace& space, const OrganizeSeed& seed,
                                         RandomKey key, const Metamers& metamers, const SceneLight& light);

}  // namespace meristem
