// SPDX-License-Identifier: Apache-2.0
// Two implementations of the perception of buds: the shade grid and the marker field of the stand. See bud_sense.h.
#include "meristem/grow/organize/bud_sense.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/scene/brighter_way.h"

namespace meristem {

namespace {

constexpr std::size_t kSensingPerBlock = 2048;  // metamers

/// Returns true if there are no lamps and the strengths of sun and sky sum to 1, so that every open position has light
/// 1.
bool is_full_everywhere(const Light& light) {
  double strength = 0;
  for (const DirectionalLight& directional : light.sun) strength += directional.strength;
  for (const DirectionalLight& directional : light.sky) strength += directional.strength;
  return light.lamps.empty() && std::abs(strength - 1) < 1e-6;
}

/// Returns the unit vector at the share `lean` of the way from `up` to the light.
Vec3 leaning(Vec3 up, Vec3 toward_light, double lean) {
  const auto share = static_cast<float>(lean);
  return normalized_or(share * toward_light + (1 - share) * up, up);
}

class ShadeSense : public BudSense {
 public:
  ShadeSense(const OrganizedSpecies& species, StandSpace& space, Vec3 root, const Metamers& metamers,
             const SceneLight& light)
      : species_(species),
        root_(root),
        metamers_(metamers),
        light_(light),
        shade_(space.shade(form_of(species, root), species.limits.mesh_bytes, species.path("light.voxel"))) {}

  void sense(BudLight& found, const Progress& progress) override {
    parallel_for(metamers_.count(), kSensingPerBlock, [&](std::size_t begin, std::size_t end) {
      progress.check();
      std::vector<MetamerIndex> asked;
      std::vector<Vec3> places;
      for (auto metamer = static_cast<MetamerIndex>(begin); metamer < end; ++metamer) {
        if (!metamers_.competes(metamer, false) && !metamers_.competes(metamer, true)) continue;
        asked.push_back(metamer);
        places.push_back(position(metamer));
      }
      std::vector<double> shade(places.size());
      ShadowGrid::Recent recent;
      shade_.shade(places, shade, recent);
      for (std::size_t k = 0; k < asked.size(); ++k) tell(asked[k], shade[k], found);
    });
  }

  bool reaches(Vec3 position) const override { return shade_.reaches(position); }

  /// Combines the direction out of the shade of plants with the direction out of the shade of obstacles, by the share
  /// of blocked light.
  Vec3 way(MetamerIndex metamer, bool, ShadowGrid::Recent& recent) const override {
    const Vec3 from_plants = normalized_or(shade_.brighter_way(position(metamer), recent), Vec3(0));
    const float blocked = 1 - std::min(1.0F, light_.at(metamer));
    if (blocked <= 0) return from_plants;
    const Vec3 from_obstacles = normalized_or(Vec3(brighter_way(species_.scene, position(metamer), 1)), Vec3(0));
    return normalized_or(from_plants + 2 * blocked * from_obstacles, Vec3(0));
  }

 private:
  static ShadowParameters form_of(const OrganizedSpecies& species, Vec3 root) {
    const BudLightModel& model = species.parameters.light;
    return {.voxel = model.voxel > 0 ? model.voxel : species.parameters.length,
            .amount = model.a,
            .base = model.b,
            .depth = model.depth,
            .toward_light = leaning(-species.directions.down(root), species.scene.light.mean_direction(), model.lean),
            .reach = model.reach};
  }
  Vec3 position(MetamerIndex metamer) const { return root_ + metamers_.tip[metamer]; }
  /// Writes the light of a metamer's buds for a given shade. Excludes the shade of the metamer itself.
  void tell(MetamerIndex metamer, double shade, BudLight& found) const {
    const BudLightModel& model = species_.parameters.light;
    const double own_per_metre = model.a / shade_.form().voxel;
    const double full = model.full * light_.at(metamer);
    const double of_others = shade - own_per_metre * metamers_.length(metamer);
    const auto left = static_cast<float>(std::clamp(full - of_others, 0.0, full));
    if (metamers_.competes(metamer, false)) found.terminal[metamer] = left;
    if (metamers_.competes(metamer, true)) found.lateral[metamer] = left;
  }

  const OrganizedSpecies& species_;
  Vec3 root_;
  const Metamers& metamers_;
  const SceneLight& light_;
  const ShadowGrid& shade_;
};

class RoomSense : public BudSense, public RoomSeeker {
 public:
  RoomSense(const OrganizedSpecies& species, StandSpace& space, const OrganizeSeed& seed, RandomKey key,
            const Metamers& metamers, const SceneLight& light)
      : species_(species), root_(seed.frame.origin), metamers_(metamers), light_(light) {
    const BudLightModel& model = species.parameters.light;
    const double length = species.parameters.length;
    const MarkerParameters form{.spacing = model.spacing * length, .occupancy = model.occupancy * length};
    field_ = &space.markers(form, key.child("markers"), species.scene.obstacles, *this, species.limits.mesh_bytes,
                            species.path("light.spacing"));
    volume_ = field_->add_volume(seed.room, root_);
  }

  bool begin_round() override { return species_.looks(round_++) || looks_again_; }
  void look_again() override { looks_again_ = true; }

  void list_seekers(std::vector<SpaceSeeker>& seekers) const override {
    const BudLightModel& model = species_.parameters.light;
    const auto radius = static_cast<float>(model.perception * species_.parameters.length);
    const auto cosine = static_cast<float>(math::cos(0.5 * model.cone));
    for_each_bud([&](MetamerIndex metamer, bool is_lateral) {
      const Vec3 heading = metamers_.bud_heading(metamer, is_lateral, species_.parameters.phyllotaxis.branching_angle);
      // A damaged bud yields to living ones. Otherwise the stump would take the space of the lateral beside it.
      const bool is_damaged = !is_lateral && metamers_.terminal[metamer].is_damaged();
      seekers.push_back({root_ + metamers_.tip[metamer], heading, volume_, radius, cosine, is_damaged});
    });
  }

  void take_room(std::span<const BudRoom> rooms) override { rooms_.assign(rooms.begin(), rooms.end()); }

  void sense(BudLight& found, const Progress& progress) override {
    const BudLightModel& model = species_.parameters.light;
    first_room_.assign(metamers_.count(), 0);
    std::uint32_t next = 0;
    for_each_bud([&](MetamerIndex metamer, bool is_lateral) {
      if (next % kSensingPerBlock == 0) progress.check();
      if (!is_lateral || !metamers_.competes(metamer, false)) first_room_[metamer] = next;
      const std::uint32_t markers = rooms_[next++].count;
      const double share = model.counts ? markers : (markers > 0 ? 1 : 0);
      (is_lateral ? found.lateral : found.terminal)[metamer] =
          static_cast<float>(model.full * light_.at(metamer) * share);
    });
  }

  bool reaches(Vec3 position) const override { return field_->reaches(position); }

  OwnRoom room() const override { return {field_, volume_}; }

  Vec3 way(MetamerIndex metamer, bool is_lateral, ShadowGrid::Recent&) const override {
    const bool is_second = is_lateral && metamers_.competes(metamer, false);
    return normalized_or(rooms_[first_room_[metamer] + (is_second ? 1 : 0)].way, Vec3(0));
  }

 private:
  template <class Visit>
  void for_each_bud(Visit visit) const {
    for (MetamerIndex metamer = 0; metamer < metamers_.count(); ++metamer) {
      if (metamers_.competes(metamer, false)) visit(metamer, false);
      if (metamers_.competes(metamer, true)) visit(metamer, true);
    }
  }

  const OrganizedSpecies& species_;
  Vec3 root_;
  const Metamers& metamers_;
  const SceneLight& light_;
  MarkerField* field_ = nullptr;
  std::uint32_t volume_ = 0;
  int round_ = 0;
  bool looks_again_ = false;
  std::vector<BudRoom> rooms_;             // results of the competing buds, in order
  std::vector<std::uint32_t> first_room_;  // by metamer
};

}  // namespace

SceneLight::SceneLight(const Scene& scene, Vec3 root)
    : scene_(scene), is_even_(scene.obstacles.empty() && is_full_everywhere(scene.light)) {
  add(root);
}

float SceneLight::reaching(Vec3 position) const {
  double arrives = 0;
  scene_.light.for_each_ray(position, [&](const LightRay& ray) {
    if (!scene_.obstacles.block(position, ray.toward, ray.distance)) arrives += ray.strength;
  });
  return static_cast<float>(arrives);
}

void SceneLight::add(Vec3 position) {
  if (!is_even_) light_.push_back(reaching(position));
}

void SceneLight::move(MetamerIndex metamer, Vec3 position) {
  if (!is_even_) light_[metamer] = reaching(position);
}

void SceneLight::remove(const std::vector<std::uint8_t>& gone) {
  if (!is_even_) erase_marked(light_, gone);
}

std::unique_ptr<BudSense> make_bud_sense(const OrganizedSpecies& species, StandSpace& space, const OrganizeSeed& seed,
                                         RandomKey key, const Metamers& metamers, const SceneLight& light) {
  if (species.parameters.light.kind == BudLightModel::Kind::markers) {
    return std::make_unique<RoomSense>(species, space, seed, key, metamers, light);
  }
  return std::make_unique<ShadeSense>(species, space, seed.frame.origin, metamers, light);
}

}  // namespace meristem
