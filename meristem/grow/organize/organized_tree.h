// SPDX-License-Identifier: Apache-2.0
// One self-organizing tree as it grows.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/grow/organize/organize.h"
#include "meristem/grow/stand_space.h"

namespace meristem {

/// What all trees of one component have in common.
struct OrganizedSpecies {
  OrganizedSpecies(const OrganizeParameters& parameters, const Scene& scene, const Limits& limits,
                   std::string component);

  OrganizeParameters parameters;
  const Scene& scene;
  Limits limits;
  std::string component;
  bool is_lit_evenly = true;  ///< nothing in the scene makes light differ from place to place
  float light_in_the_open = 1;

  std::string path(const std::string& parameter) const;
  [[noreturn]] void refuse(const std::string& parameter, std::string message, std::string expected,
                           std::string nearest = {}) const;
};

class OrganizedTree : public RoomSeeker {
 public:
  OrganizedTree(const OrganizedSpecies& species, StandSpace& space, const OrganizeSeed& seed, RandomKey key);
  OrganizedTree(const OrganizedTree&) = delete;

  /// Counts the light of all buds as the stand's space is now, and divides the resource that it makes.
  void sense(int iteration, const Progress& progress);
  /// Grows, sheds, sags and is cut; after sense(). `metamers` are those of the whole component so far.
  void iterate(int iteration, std::uint64_t metamers, const Progress& progress);

  const Metamers& metamers() const { return metamers_; }
  bool has_grown() const { return has_grown_; }
  double resource_of_seed() const { return flow_.resource.empty() ? 0 : flow_.resource[0]; }
  const ResourceFlow& flow() const { return flow_; }
  /// In world space; to be called once.
  Skeleton take_skeleton(const Progress& progress);

  void list_seekers(std::vector<Seeker>& seekers) const override;
  void take_room(std::span<const Room> rooms) override { rooms_.assign(rooms.begin(), rooms.end()); }

 private:
  /// A bud that grows in this iteration.
  struct Sprout {
    MetamerIndex from = 0;
    bool is_lateral = false;
    int metamers = 1;
    float length = 0;  // of each
    Vec3 to_light{0};  // unit vector, or 0
  };

  bool gathers(MetamerIndex metamer, bool is_lateral) const;
  void sense_shade(const Progress& progress);
  void sense_room();
  std::vector<Sprout> find_sprouts() const;
  void aim(std::vector<Sprout>& sprouts, const Progress& progress) const;
  Vec3 way_out_of_shade(Vec3 place) const;
  void grow(const Sprout& sprout, int iteration);
  Vec3 direction(const Sprout& sprout, MetamerIndex from, int k, Vec3 bud, int iteration) const;
  bool is_open(Vec3 from, Vec3 to) const;
  void shed(int iteration);
  void sag(int iteration);
  void cut(int iteration);
  void remove(std::vector<std::uint8_t>& gone, Bud after);
  /// Light that reaches a place past obstacles, as a share of what is full.
  float open_light(Vec3 place) const;
  Vec3 world(MetamerIndex metamer) const { return root_ + metamers_.tip[metamer]; }

  const OrganizedSpecies* species_;
  StandSpace* space_;
  const ShadowGrid* shade_ = nullptr;
  std::uint32_t room_ = 0;  // the volume of its markers
  Vec3 root_;
  Metamers metamers_;
  std::vector<float> open_light_;  // by metamer, where obstacles or lamps stand
  BudLight light_;
  ResourceFlow flow_;
  std::vector<Room> rooms_;                // of the buds that gather light, in order
  std::vector<std::uint32_t> first_room_;  // of each metamer
  std::optional<BranchLoad> load_;
  bool has_grown_ = false;
};

}  // namespace meristem
