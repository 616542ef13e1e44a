// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/grow/organize/bud_sense.h"
#include "meristem/grow/organize/metamers.h"
#include "meristem/grow/organize/resource.h"
#include "meristem/grow/organize/species.h"
#include "meristem/grow/organize/standing_tree.h"
#include "meristem/grow/stand_space.h"

namespace meristem {

/// One self-organizing tree as it grows. `species` and `space` outlive it.
class OrganizedTree {
 public:
  OrganizedTree(const OrganizedSpecies& species, StandSpace& space, const OrganizeSeed& seed, RandomKey key);
  OrganizedTree(const OrganizedTree&) = delete;
  OrganizedTree& operator=(const OrganizedTree&) = delete;

  /// Counts the light of all buds as the stand's space is now, and divides the resource that it makes.
  void sense(int iteration, const Progress& progress);
  /// Finds the buds that will grow in this iteration; after sense(). Returns how many metamers they will make at most.
  std::uint64_t plan();
  /// Grows, sags, sheds, and people do to it what they will; after plan().
  void iterate(int iteration, const Progress& progress);
  /// Tells the stand's space of all that.
  void tell() { tree_.tell(); }

  const Metamers& metamers() const { return tree_.metamers(); }
  bool has_grown() const { return has_grown_; }
  const ResourceFlow& flow() const { return flow_; }  ///< of the last sense()
  /// In world space; to be called once.
  Skeleton take_skeleton(const Progress& progress);

 private:
  /// A bud that grows in this iteration.
  struct Sprout {
    MetamerIndex from = 0;
    bool is_lateral = false;
    int metamers = 1;
    float length = 0;  // of each
    Vec3 way{0};       // to light or room: a unit vector, or 0
  };

  void grow(const Sprout& sprout, int iteration);
  Vec3 wanted_heading(const Sprout& sprout, MetamerIndex from, Vec3 bud, int iteration) const;
  std::optional<Vec3> free_heading(MetamerIndex from, Vec3 wanted, float length, RandomKey key) const;
  Vec3 next_side(MetamerIndex from, bool is_lateral, std::uint32_t number, Vec3 heading, RandomKey key) const;
  bool is_open(Vec3 from, Vec3 to) const;
  void shed(int iteration);
  void operate(int iteration, const Progress& progress);
  void perform(const Cut& cut, int iteration);

  const OrganizedSpecies* species_;
  Vec3 root_;
  StandingTree tree_;
  const Metamers& metamers_;  // of the tree
  std::unique_ptr<BudSense> senses_;
  BudLight light_;
  ResourceFlow flow_;
  std::vector<Sprout> sprouts_;  // of the iteration
  bool has_grown_ = false;
};

}  // namespace meristem
