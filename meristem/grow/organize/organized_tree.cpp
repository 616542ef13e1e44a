// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/organized_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/scene/brighter_way.h"

namespace meristem {

namespace {

constexpr std::size_t kGrain = 2048;  // metamers
constexpr int kTries = 4;             // directions a bud tries where obstacles or the ground stand in its way
constexpr double kTryTurn = 0.5;      // radians, more with each of them
// Opposite buds are two metamers, of which the second has this share of the length of both.
constexpr float kPairGap = 0.04F;

}  // namespace

OrganizedSpecies::OrganizedSpecies(const OrganizeParameters& given, const Scene& around, const Limits& most,
                                   std::string id)
    : parameters(given), scene(around), limits(most), component(std::move(id)) {
  is_lit_evenly = scene.obstacles.empty() && scene.light.lamps.empty();
}

std::string OrganizedSpecies::path(const std::string& parameter) const {
  return fmt::format("components.{}.{}", component, parameter);
}

void OrganizedSpecies::refuse(const std::string& parameter, std::string message, std::string expected,
                              std::string nearest) const {
  throw InputError(Diagnostic{.message = std::move(message),
                              .expected = std::move(expected),
                              .nearest = std::move(nearest),
                              .path = path(parameter)});
}

OrganizedTree::OrganizedTree(const OrganizedSpecies& species, StandSpace& space, const OrganizeSeed& seed,
                             RandomKey key)
    : species_(&species),
      space_(&space),
      root_(seed.frame.origin),
      metamers_(normalized_or(seed.frame.heading(), kUp), normalized_or(seed.frame.right(), Vec3(1, 0, 0)), key) {
  const OrganizeParameters& parameters = species.parameters;
  const BudLightModel& light = parameters.light;
  if (light.kind == BudLightModel::Kind::shadow) {
    const ShadowForm form{.voxel = light.voxel > 0 ? light.voxel : parameters.length,
                          .amount = light.a,
                          .base = light.b,
                          .depth = light.depth,
                          .toward_light = species.scene.light.mean_direction(),
                          .reach = light.reach};
    shade_ = &space.shade(form, species.limits.mesh_bytes, species.path("light.voxel"));
  } else {
    const MarkerForm form{.spacing = light.spacing * parameters.length,
                          .occupancy = light.occupancy * parameters.length};
    MarkerField& field = space.markers(form, key.child("markers"), species.scene.obstacles, *this,
                                       species.limits.mesh_bytes, species.path("light.spacing"));
    room_ = field.add_volume(seed.room, root_);
  }
  if (parameters.sag) load_.emplace(*parameters.sag, parameters.radii);
  if (!species.is_lit_evenly) open_light_.push_back(open_light(root_));
}

/// Whether a bud has light to compete with: an open one, or a damaged one at the end of an axis.
bool OrganizedTree::gathers(MetamerIndex metamer, bool is_lateral) const {
  const Bud bud = (is_lateral ? metamers_.lateral : metamers_.terminal)[metamer];
  return bud.is_open() || (!is_lateral && bud.is_damaged());
}

void OrganizedTree::sense(int iteration, const Progress& progress) {
  light_.resize(metamers_.count());
  if (shade_ != nullptr) {
    sense_shade(progress);
  } else {
    sense_room();
  }
  gather_light(metamers_, light_, flow_);
  const OrganizeParameters& parameters = species_->parameters;
  const double age = std::min(1.0, static_cast<double>(iteration - 1) / parameters.maturity);
  divide_resource(metamers_, light_, parameters.resource, iteration, age, flow_);
}

void OrganizedTree::sense_shade(const Progress& progress) {
  const BudLightModel& light = species_->parameters.light;
  const double per_metre = light.a / shade_->form().voxel;
  parallel_for(metamers_.count(), kGrain, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (auto metamer = static_cast<MetamerIndex>(begin); metamer < end; ++metamer) {
      const bool terminal = gathers(metamer, false);
      const bool lateral = gathers(metamer, true);
      if (!terminal && !lateral) continue;
      const double open = open_light_.empty() ? light.full : light.full * open_light_[metamer];
      const double others = shade_->shade(world(metamer)) - per_metre * metamers_.length(metamer);
      const auto left = static_cast<float>(std::clamp(open - others, 0.0, open));
      if (terminal) light_.terminal[metamer] = left;
      if (lateral) light_.lateral[metamer] = left;
    }
  });
}

void OrganizedTree::list_seekers(std::vector<Seeker>& seekers) const {
  const OrganizeParameters& parameters = species_->parameters;
  const auto radius = static_cast<float>(parameters.light.perception * parameters.length);
  const auto cosine = static_cast<float>(math::cos(0.5 * parameters.light.cone));
  const double angle = parameters.phyllotaxis.branching_angle;
  const auto along = static_cast<float>(math::cos(angle));
  const auto aside = static_cast<float>(math::sin(angle));
  for (MetamerIndex metamer = 0; metamer < metamers_.count(); ++metamer) {
    const bool terminal = gathers(metamer, false);
    const bool lateral = gathers(metamer, true);
    if (!terminal && !lateral) continue;
    const Vec3 heading = metamers_.heading(metamer);
    const Vec3 place = world(metamer);
    if (terminal) seekers.push_back({place, heading, room_, radius, cosine});
    if (lateral) {
      seekers.push_back({place, along * heading + aside * metamers_.side[metamer], room_, radius, cosine});
    }
  }
}

void OrganizedTree::sense_room() {
  const BudLightModel& light = species_->parameters.light;
  first_room_.assign(metamers_.count(), 0);
  std::uint32_t next = 0;
  const auto light_of = [&](const Room& room) {
    if (room.count == 0) return 0.0F;
    return static_cast<float>(light.counts ? light.full * room.count : light.full);
  };
  for (MetamerIndex metamer = 0; metamer < metamers_.count(); ++metamer) {
    first_room_[metamer] = next;
    const float open = open_light_.empty() ? 1 : open_light_[metamer];
    if (gathers(metamer, false)) light_.terminal[metamer] = open * light_of(rooms_[next++]);
    if (gathers(metamer, true)) light_.lateral[metamer] = open * light_of(rooms_[next++]);
  }
}

void OrganizedTree::iterate(int iteration, std::uint64_t metamers, const Progress& progress) {
  std::vector<Sprout> sprouts = find_sprouts();
  std::uint64_t more = 0;
  for (const Sprout& sprout : sprouts) more += static_cast<std::uint64_t>(sprout.metamers);
  if (metamers + more > species_->limits.nodes) {
    throw_limit(fmt::format("metamers in iteration {}", iteration), static_cast<double>(metamers + more),
                species_->limits.nodes, "nodes", species_->path("resource.alpha"));
  }
  aim(sprouts, progress);
  metamers_.reserve(metamers_.count() + more);
  for (std::size_t k = 0; k < sprouts.size(); ++k) {
    if (k % kGrain == 0) progress.check();
    grow(sprouts[k], iteration);
  }
  if (load_) sag(iteration);
  shed(iteration);
  cut(iteration);
}

std::vector<OrganizedTree::Sprout> OrganizedTree::find_sprouts() const {
  const OrganizeParameters& parameters = species_->parameters;
  std::vector<Sprout> sprouts;
  const auto add = [&](MetamerIndex from, bool is_lateral, double resource, double threshold) {
    if (!(resource >= threshold)) return;
    const double whole = std::clamp(std::floor(resource), 1.0, static_cast<double>(parameters.longest_shoot));
    const double stretch = parameters.stretch ? std::clamp(resource / whole, 0.1, 10.0) : 1;
    sprouts.push_back(
        {from, is_lateral, static_cast<int>(whole), static_cast<float>(stretch * parameters.length), Vec3(0)});
  };
  for (MetamerIndex metamer = 0; metamer < metamers_.count(); ++metamer) {
    const Bud terminal = metamers_.terminal[metamer];
    const bool is_terminal_lit = light_.terminal[metamer] > 0;
    const std::size_t before = sprouts.size();
    if (terminal.is_open() && is_terminal_lit) {
      add(metamer, false, flow_.terminal(metamer), parameters.terminal_threshold);
    }
    const bool may_open = !terminal.is_open() || sprouts.size() > before || !parameters.laterals_wait;
    if (metamers_.lateral[metamer].is_open() && may_open && light_.lateral[metamer] > 0) {
      const bool leads = terminal.is_damaged();
      add(metamer, true, flow_.lateral(metamer), leads ? parameters.terminal_threshold : parameters.lateral_threshold);
    }
  }
  return sprouts;
}

/// Finds for each sprout where there is light or room.
void OrganizedTree::aim(std::vector<Sprout>& sprouts, const Progress& progress) const {
  parallel_for(sprouts.size(), kGrain / 16, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (std::size_t k = begin; k < end; ++k) {
      Sprout& sprout = sprouts[k];
      if (shade_ != nullptr) {
        sprout.to_light = way_out_of_shade(world(sprout.from));
      } else {
        const bool is_second = sprout.is_lateral && gathers(sprout.from, false);
        sprout.to_light = normalized_or(rooms_[first_room_[sprout.from] + (is_second ? 1 : 0)].way, Vec3(0));
      }
    }
  });
}

/// Out of the shade of plants, and as far as obstacles take the light also out of theirs.
Vec3 OrganizedTree::way_out_of_shade(Vec3 place) const {
  const Vec3 from_plants = normalized_or(shade_->brighter_way(place), Vec3(0));
  if (species_->scene.obstacles.empty()) return from_plants;
  const float blocked = 1 - std::min(1.0F, open_light(place));
  if (blocked <= 0) return from_plants;
  const Vec3 from_obstacles = normalized_or(Vec3(brighter_way(species_->scene, place, 1)), Vec3(0));
  return normalized_or(from_plants + 2 * blocked * from_obstacles, Vec3(0));
}

float OrganizedTree::open_light(Vec3 place) const {
  double arrives = 0;
  species_->scene.light.for_each_ray(place, [&](const LightRay& ray) {
    if (!species_->scene.obstacles.block(place, ray.toward, ray.distance)) arrives += ray.strength;
  });
  return static_cast<float>(arrives);
}

/// Grows the metamers of one bud, as far as nothing stands in their way.
void OrganizedTree::grow(const Sprout& sprout, int iteration) {
  const Phyllotaxis& phyllotaxis = species_->parameters.phyllotaxis;
  MetamerIndex from = sprout.from;
  const Vec3 axis = metamers_.heading(from);
  Vec3 bud = axis;
  if (sprout.is_lateral) {
    const double angle = phyllotaxis.branching_angle;
    bud = static_cast<float>(math::cos(angle)) * axis + static_cast<float>(math::sin(angle)) * metamers_.side[from];
  }
  for (int k = 0; k < sprout.metamers; ++k) {
    const bool is_lateral = sprout.is_lateral && k == 0;
    const std::uint32_t number = is_lateral ? 1 : metamers_.number[from] + 1;
    float length = sprout.length;
    if (phyllotaxis.kind == Phyllotaxis::Kind::decussate) {
      length *= 2 * (number % 2 == 0 ? kPairGap : 1 - kPairGap);
    }
    const RandomKey shoot = metamers_.axes[metamers_.axis[from]].key;
    const RandomKey key = (is_lateral ? shoot.child(metamers_.number[from]) : shoot).child("metamer").child(number);
    const Vec3 wanted = direction(sprout, from, k, bud, iteration);
    const double tilt = phyllotaxis.jitter * key.normal(0);
    std::optional<Vec3> heading;
    for (int attempt = 0; attempt < kTries && !heading; ++attempt) {
      const double turn = attempt == 0 ? tilt : kTryTurn * attempt;
      const Vec3 across = any_perpendicular(wanted);
      const Mat3 about = rotation(wanted, 2 * kPi * key.uniform(1 + static_cast<std::uint64_t>(attempt)));
      const Vec3 tried = rotation(about * across, turn) * wanted;
      if (is_open(metamers_.tip[from], metamers_.tip[from] + length * tried)) heading = tried;
    }
    if (!heading) return;

    const MetamerIndex made = metamers_.grow(from, is_lateral, iteration);
    has_grown_ = true;
    metamers_.tip[made] = metamers_.tip[from] + length * *heading;
    // Lateral buds go around the axis from one to the next; the first of a branch stands aside, at right angles to
    // branch and mother.
    Vec3 side = metamers_.side[from];
    double turn = 0;
    if (is_lateral) {
      side = glm::cross(*heading, axis);
    } else if (phyllotaxis.kind == Phyllotaxis::Kind::spiral) {
      turn = phyllotaxis.divergence;
    } else {
      turn = phyllotaxis.kind == Phyllotaxis::Kind::decussate && number % 2 != 0 ? kPi / 2 : kPi;
    }
    side -= glm::dot(side, *heading) * *heading;
    side = normalized_or(side, any_perpendicular(*heading));
    metamers_.side[made] = rotation(*heading, turn + phyllotaxis.jitter * key.child("side").normal(0)) * side;
    if (!open_light_.empty()) open_light_.push_back(open_light(world(made)));
    if (space_->is_felt()) space_->grow_shoot(world(made), metamers_.length(made));
    bud = *heading;
    from = made;
  }
}

/// The unit vector in which the k-th metamer of a sprout wants to grow.
Vec3 OrganizedTree::direction(const Sprout& sprout, MetamerIndex from, int k, Vec3 bud, int iteration) const {
  const OrganizeParameters& parameters = species_->parameters;
  const int order = metamers_.order[from] + (sprout.is_lateral && k == 0 ? 1 : 0);
  const DirectionWeights& weights = order == 0 && parameters.stem ? *parameters.stem : parameters.direction;
  const double steps = weights.fades_by_order ? order : iteration - 1;
  const double up = weights.up_later + (weights.up - weights.up_later) * math::pow(weights.up_fade, steps);
  DVec3 sum = weights.persistence * DVec3(bud) + weights.light * DVec3(sprout.to_light) + up * DVec3(kUp);
  const bool leads = sprout.is_lateral && k == 0 && metamers_.terminal[from].is_damaged();
  if (leads) sum += parameters.takeover * DVec3(metamers_.heading(from));
  return normalized_or(Vec3(sum), bud);
}

/// Whether nothing stands at `to` or on the way there, both relative to the root, nor the ground.
bool OrganizedTree::is_open(Vec3 from, Vec3 to) const {
  if (to.y < 0 && to.y < from.y) return false;
  const Obstacles& obstacles = species_->scene.obstacles;
  if (obstacles.empty()) return true;
  const Vec3 begin = from == Vec3(0) ? 0.001F * to : from;
  return !(obstacles.cross(root_ + begin, root_ + to) || obstacles.contain(root_ + to));
}

void OrganizedTree::shed(int iteration) {
  const Shedding& shedding = species_->parameters.shedding;
  if (shedding.below <= 0) return;
  // The light of the round's begin must do for what a shoot has now, with what has just grown: the reading that keeps
  // as many metamers as the published shares say (81 % at a threshold of 0.1, 43 % at 0.3).
  std::vector<std::uint32_t> borne(metamers_.count(), 1);
  for (std::size_t metamer = metamers_.count(); metamer-- > 1;) borne[metamers_.parent[metamer]] += borne[metamer];
  std::vector<std::uint8_t> gone(metamers_.count(), 0);
  bool any = false;
  for (MetamerIndex metamer = 1; metamer < flow_.light.size(); ++metamer) {
    if (!metamers_.begins_shoot(metamer) || metamers_.birth[metamer] + shedding.after >= iteration) continue;
    if (flow_.light[metamer] < shedding.below * borne[metamer]) {
      gone[metamer] = 1;
      any = true;
    }
  }
  if (any) remove(gone, Bud::dead());
}

void OrganizedTree::sag(int iteration) {
  const std::vector<Vec3> before = metamers_.tip;
  std::vector<float> length(metamers_.count());
  for (MetamerIndex metamer = 0; metamer < metamers_.count(); ++metamer) length[metamer] = metamers_.length(metamer);
  load_->bend(metamers_, iteration);
  if (!space_->is_felt()) return;
  for (MetamerIndex metamer = 1; metamer < metamers_.count(); ++metamer) {
    if (metamers_.tip[metamer] == before[metamer]) continue;
    space_->lose_shoot(root_ + before[metamer], length[metamer]);
    space_->grow_shoot(world(metamer), metamers_.length(metamer));
  }
}

void OrganizedTree::cut(int iteration) {
  const std::vector<Cut>& cuts = species_->parameters.cuts;
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const Cut& cut = cuts[k];
    if (cut.at != iteration) continue;
    const auto refuse = [&](const char* key, std::string message, std::string expected, std::string nearest = {}) {
      species_->refuse(fmt::format("operations[{}].{}", k, key), std::move(message), std::move(expected),
                       std::move(nearest));
    };
    const std::optional<AxisIndex> shoot = metamers_.find_shoot(cut.shoot);
    if (!shoot) {
      // The names that are there are those on the longest part of this one that is.
      std::string known = cut.shoot;
      while (!known.empty() && !metamers_.find_shoot(known)) {
        const std::size_t dot = known.find_last_of('.');
        known.resize(dot == std::string::npos ? 0 : dot);
      }
      const AxisIndex on = known.empty() ? 0 : *metamers_.find_shoot(known);
      std::vector<std::string> names = metamers_.shoots_on(on);
      names.insert(names.begin(), metamers_.name_of(on));
      const std::string nearest = nearest_name(cut.shoot, names);
      if (names.size() > 12) names.resize(12);
      refuse("shoot", fmt::format("there is no shoot '{}' after iteration {}", cut.shoot, iteration),
             fmt::format("one that has grown: {}", fmt::join(names, ", ")), nearest);
    }
    const MetamerIndex last = metamers_.axes[*shoot].last;
    if (metamers_.number[last] <= static_cast<std::uint32_t>(cut.above)) {
      refuse("above",
             fmt::format("'{}' has {} metamers after iteration {}, so there is nothing above {}", cut.shoot,
                         metamers_.number[last], iteration, cut.above),
             "a number below that");
    }
    if (*shoot == 0 && cut.above == 0) {
      refuse("above", "nothing would be left of the tree", "a whole number of at least 1");
    }
    std::vector<std::uint8_t> gone(metamers_.count(), 0);
    gone[*metamers_.find(*shoot, static_cast<std::uint32_t>(cut.above) + 1)] = 1;
    remove(gone, species_->parameters.damage ? Bud::damaged() : Bud());
  }
}

void OrganizedTree::remove(std::vector<std::uint8_t>& gone, Bud after) {
  // The lengths and places must be read before parents go.
  for (MetamerIndex metamer = 1; metamer < metamers_.count(); ++metamer) {
    if (gone[metamers_.parent[metamer]] != 0) gone[metamer] = 1;
    if (gone[metamer] != 0 && space_->is_felt()) space_->lose_shoot(world(metamer), metamers_.length(metamer));
  }
  metamers_.remove(gone, after);
  if (load_) load_->remove(gone);
  if (!open_light_.empty()) {
    std::size_t k = 0;
    std::erase_if(open_light_, [&](float) { return gone[k++] != 0; });
  }
}

Skeleton OrganizedTree::take_skeleton(const Progress& progress) {
  const std::size_t count = metamers_.count();
  Skeleton skeleton;
  skeleton.parent = metamers_.parent;
  skeleton.position.resize(count);
  std::vector<float>& angle = skeleton.extra["bud_angle"];
  angle.resize(count);
  parallel_for(count, kGrain, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (auto metamer = static_cast<MetamerIndex>(begin); metamer < end; ++metamer) {
      skeleton.position[metamer] = world(metamer);
      const Frame frame = frame_along(Vec3(0), metamers_.heading(metamer), kUp);
      const Vec3 side = metamers_.side[metamer];
      angle[metamer] = static_cast<float>(math::atan2(glm::dot(side, frame.right()), glm::dot(side, frame.upper())));
    }
  });
  skeleton.radius.assign(count, 0);
  skeleton.axis = std::move(metamers_.axis);
  skeleton.order = std::move(metamers_.order);
  skeleton.birth.assign(metamers_.birth.begin(), metamers_.birth.end());
  skeleton.extra["metamer"].assign(metamers_.number.begin(), metamers_.number.end());
  skeleton.extra["light"].assign(flow_.light.begin(), flow_.light.end());
  skeleton.extra["resource"].assign(flow_.resource.begin(), flow_.resource.end());
  const auto states = [&](const std::vector<Bud>& buds) {
    std::vector<float> column(count);
    std::ranges::transform(buds, column.begin(), [](Bud bud) { return static_cast<float>(bud.state()); });
    return column;
  };
  skeleton.extra["terminal_bud"] = states(metamers_.terminal);
  skeleton.extra["lateral_bud"] = states(metamers_.lateral);
  skeleton.extra["shed"] = std::move(metamers_.lost_tips);
  progress.check();
  assign_pipe_radii(skeleton, species_->parameters.radii);
  return skeleton;
}

Vec3 bud_side(Vec3 heading, double bud_angle) {
  const Frame frame = frame_along(Vec3(0), heading, kUp);
  return static_cast<float>(math::sin(bud_angle)) * frame.right() +
         static_cast<float>(math::cos(bud_angle)) * frame.upper();
}

}  // namespace meristem
