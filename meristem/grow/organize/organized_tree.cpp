// SPDX-License-Identifier: Apache-2.0
// One self-organizing tree: perception, division of resource, growth, shedding and loss of its metamers.
// tree_operations.cpp has the operations on it.
#include "meristem/grow/organize/organized_tree.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/plant/further_columns.h"

namespace meristem {

namespace {

constexpr std::size_t kMetamersPerBlock = 2048;  // metamers
constexpr std::size_t kSproutsAtOnce = 128;      // sprouts per block that search for light
constexpr int kTries = 4;                        // headings that a bud tries if obstacles block its way
constexpr double kTryTurn = 0.5;  // radians from the desired heading for the first retry; multiplied for later ones
// Opposite buds are modelled as two metamers. The second has this share of their total length.
constexpr float kPairGap = 0.04F;
constexpr std::string_view kTerminalBudColumn = "terminal_bud";
constexpr std::string_view kLateralBudColumn = "lateral_bud";

}  // namespace

OrganizedTree::OrganizedTree(const OrganizedSpecies& species, StandSpace& space, const OrganizeSeed& seed,
                             RandomKey key, int number)
    : species_(&species),
      root_(seed.frame.origin),
      key_(key),
      number_(number),
      room_(seed.room),
      tree_({species.scene, species.directions, root_}, space,
            Metamers(normalized_or(seed.frame.heading(), -species.directions.down(root_)),
                     normalized_or(seed.frame.right(), Vec3(1, 0, 0)), key),
            species.parameters.sag, species.parameters.radii),
      metamers_(tree_.metamers()),
      senses_(make_bud_sense(species, space, seed, key, metamers_, tree_.scene_light())),
      ties_(species, root_) {
  upkeep_.is_done.assign(species.parameters.operations.size(), 0);
  if (!senses_->reaches(root_)) {
    species.refuse("roots", "a root is too far away from the origin for metamers so short",
                   "a position nearer to the origin, or a larger 'length'");
  }
}

void OrganizedTree::stand(const Skeleton& wood) {
  const std::vector<WoodMetamer> standing = metamers_of_wood(wood, species_->parameters.length);
  const auto angles = wood.extra.find(kBudAngleColumn);
  tree_.reserve(standing.size() + 1);
  for (const WoodMetamer& next : standing) {
    if (!senses_->reaches(root_ + next.tip)) {
      species_->refuse("skeleton", "the tree is too far away from the origin, or too large, for metamers so short",
                       "a smaller 'unit', a position nearer to the origin, or a larger 'length'");
    }
    const std::uint32_t number = next.is_lateral ? 1 : metamers_.number[next.from] + 1;
    const Vec3 heading = normalized_or(next.tip - metamers_.tip[next.from], metamers_.heading(next.from));
    const RandomKey key = metamers_.key_of_shoot(next.from, next.is_lateral).child("metamer").child(number);
    const bool is_told = angles != wood.extra.end() && next.node != kNoNode;
    const Vec3 side = is_told ? bud_side(heading, static_cast<double>(angles->second[next.node]))
                              : next_side(next.from, next.is_lateral, number, heading, key);
    tree_.grow(next.from, next.is_lateral, 0, next.tip, side);
  }
  for (MetamerIndex k = 0; k < standing.size(); ++k) close_buds(wood, standing[k].node, k + 1);
  wood_.stand(metamers_, wood.radius[0], standing);
  tree_.settle();
  has_grown_ = !standing.empty();
}

void OrganizedTree::close_buds(const Skeleton& wood, NodeIndex node, MetamerIndex metamer) {
  if (node == kNoNode) return;
  for (const bool is_lateral : {false, true}) {
    const auto states = wood.extra.find(is_lateral ? kLateralBudColumn : kTerminalBudColumn);
    if (states == wood.extra.end()) continue;
    const float state = states->second[node];
    if (state == static_cast<float>(Bud::State::damaged)) tree_.close(metamer, is_lateral, Bud::damaged());
    if (state == static_cast<float>(Bud::State::dead)) tree_.close(metamer, is_lateral, Bud::dead());
  }
}

void OrganizedTree::sense(int iteration, const Progress& progress) {
  light_.resize(metamers_.count());
  senses_->sense(light_, progress);
  progress.check();
  gather_light(metamers_, light_, flow_);
  progress.check();
  const OrganizeParameters& parameters = species_->parameters;
  const double age = std::min(1.0, static_cast<double>(iteration - 1) / parameters.maturity);
  iteration_ = iteration;
  if (!parameters.bearing) {
    divide_resource(metamers_, light_, parameters.resource, iteration, age, flow_, ringed(iteration));
    return;
  }
  ResourceModel model = parameters.resource;
  crop_.begin(metamers_, iteration);
  const double left = 1 - crop_.share_of(model.alpha0 + model.alpha * flow_.light[0], *parameters.bearing);
  model.alpha0 *= left;
  model.alpha *= left;
  divide_resource(metamers_, light_, model, iteration, age, flow_, ringed(iteration));
  crop_.choose(metamers_, flow_, *parameters.bearing, iteration);
}

/// Returns a name of a metamer's buds that does not change when other metamers are removed.
std::uint64_t OrganizedTree::name_of_bud(MetamerIndex metamer) const {
  return metamers_.axes[metamers_.axis[metamer]].key.child(metamers_.number[metamer]).bits();
}

std::uint64_t OrganizedTree::plan(Flush flush) {
  const OrganizeParameters& parameters = species_->parameters;
  const auto share_of = [&](int whole) {
    if (flush == Flush::whole) return whole;
    const double share = flush == Flush::first ? parameters.summer : 1 - parameters.summer;
    return std::clamp(static_cast<int>(share * whole + 0.5), 1, whole);
  };
  const std::vector<std::uint8_t> near = near_wounds();
  std::uint64_t metamers = 0;
  const auto add = [&](MetamerIndex from, bool is_lateral, double resource, double threshold) {
    if (!(resource >= threshold)) return false;
    const double whole = std::clamp(std::floor(resource), 1.0, static_cast<double>(parameters.longest_shoot));
    const double stretch = parameters.stretch ? std::clamp(resource / whole, 0.1, 10.0) : 1;
    Sprout sprout{from, is_lateral, share_of(static_cast<int>(whole)), static_cast<float>(stretch * parameters.length)};
    if (flush == Flush::first) sprout.left = static_cast<int>(whole) - sprout.metamers;
    sprouts_.push_back(sprout);
    metamers += static_cast<std::uint64_t>(sprout.metamers);
    return true;
  };
  for (MetamerIndex metamer = 0; metamer < metamers_.count(); ++metamer) {
    const Bud terminal = metamers_.terminal[metamer];
    if (flush == Flush::rest) {
      const auto owed = terminal.is_open() ? owed_.find(name_of_bud(metamer)) : owed_.end();
      if (owed != owed_.end()) {
        sprouts_.push_back({metamer, false, owed->second.metamers, owed->second.length});
        metamers += static_cast<std::uint64_t>(owed->second.metamers);
        continue;
      }
      // Other buds wait for the next iteration, except buds of shoots cut in this summer.
      if (answering_.count(metamers_.axes[metamers_.axis[metamer]].key.bits()) == 0) continue;
    }
    const bool goes_on = terminal.is_open() && light_.terminal[metamer] > 0 &&
                         add(metamer, false, flow_.terminal(metamer), parameters.terminal_threshold);
    if (!metamers_.lateral[metamer].is_open() || !(light_.lateral[metamer] > 0)) continue;
    if (crop_.bears(metamer)) continue;
    const bool is_near = !near.empty() && near[metamer] != 0 && !terminal.is_damaged();
    const bool may_open = goes_on || !terminal.is_open() || !parameters.laterals_wait || is_near;
    // A lateral beside a cut terminal continues the axis, so it needs the terminal's threshold.
    double threshold = terminal.is_damaged() ? parameters.terminal_threshold : parameters.lateral_threshold;
    if (is_near) threshold = std::min(threshold, parameters.water_shoots->threshold);
    if (may_open && add(metamer, true, flow_.lateral(metamer), threshold)) sprouts_.back().is_water_shoot = is_near;
  }
  owed_.clear();
  answering_.clear();
  return metamers;
}

/// Marks the metamers near large cuts whose lateral buds may become water shoots. Returns an empty list without such
/// shoots.
std::vector<std::uint8_t> OrganizedTree::near_wounds() const {
  const std::optional<WaterShoots>& shoots = species_->parameters.water_shoots;
  if (!shoots) return {};
  std::vector<std::uint8_t> near(metamers_.count(), 0);
  upkeep_.wounds.for_each([&](MetamerIndex metamer, float cut_at, float cut_metamers) {
    if (static_cast<float>(iteration_) - cut_at > static_cast<float>(shoots->years)) return;
    if (cut_metamers < static_cast<float>(shoots->cut)) return;
    for (int k = 0; k <= shoots->within && metamer != 0; ++k, metamer = metamers_.parent[metamer]) near[metamer] = 1;
  });
  return near;
}

void OrganizedTree::iterate(int iteration, Flush flush, const Progress& progress) {
  std::vector<Sprout> sprouts = std::exchange(sprouts_, {});
  // All sprouts use the light at the begin of the round.
  parallel_for(sprouts.size(), kSproutsAtOnce, [&](std::size_t begin, std::size_t end) {
    progress.check();
    ShadowGrid::Recent recent;
    for (std::size_t k = begin; k < end; ++k) {
      sprouts[k].way = senses_->way(sprouts[k].from, sprouts[k].is_lateral, recent);
    }
  });
  if (species_->parameters.request.has(TracePart::ways)) record_ways(sprouts, flush);
  if (is_pruned()) tie_shoots(iteration);
  std::uint64_t more = 0;
  for (const Sprout& sprout : sprouts) more += static_cast<std::uint64_t>(sprout.metamers);
  tree_.reserve(metamers_.count() + more);
  for (std::size_t k = 0; k < sprouts.size(); ++k) {
    if (k % kMetamersPerBlock == 0) progress.check();
    grow(sprouts[k], iteration);
  }
  progress.check();
  if (flush == Flush::first) return operate(iteration, true, progress);
  tree_.sag(iteration);
  progress.check();
  shed(iteration);
  if (is_pruned()) operate(iteration, false, progress);
}

/// Grows the metamers of one bud until an obstacle blocks them.
void OrganizedTree::grow(const Sprout& sprout, int iteration) {
  const Phyllotaxis& phyllotaxis = species_->parameters.phyllotaxis;
  MetamerIndex from = sprout.from;
  Growth growth{sprout, iteration, metamers_.order[from] + (sprout.is_lateral ? 1 : 0), 0};
  if (is_pruned()) {
    growth.rank = upkeep_.leads.rank_of_bud(metamers_, from, sprout.is_lateral);
    growth.tie = ties_.of_bud(metamers_, upkeep_.leads, from, sprout.is_lateral);
  }
  const double jitter = phyllotaxis.jitter / (1 + (growth.tie == 0 ? 0 : ties_.weight(growth.tie)));
  Vec3 bud = metamers_.bud_heading(from, sprout.is_lateral, phyllotaxis.branching_angle);
  for (int k = 0; k < sprout.metamers; ++k) {
    const bool is_lateral = sprout.is_lateral && k == 0;
    const std::uint32_t number = is_lateral ? 1 : metamers_.number[from] + 1;
    float length = sprout.length;
    if (phyllotaxis.kind == Phyllotaxis::Kind::decussate) length *= 2 * (number % 2 == 0 ? kPairGap : 1 - kPairGap);
    const RandomKey shoot = metamers_.key_of_shoot(from, is_lateral);
    const RandomKey key = shoot.child("metamer").child(number);
    const auto heading = free_heading(from, wanted_heading(growth, from, bud), length, key, jitter);
    if (!heading) return;

    const Vec3 side = next_side(from, is_lateral, number, *heading, key);
    from = tree_.grow(from, is_lateral, iteration, metamers_.tip[from] + length * *heading, side);
    if (is_lateral && growth.tie != 0) tree_.tie(metamers_.axis[from], growth.tie);
    has_grown_ = true;
    bud = *heading;
  }
  if (sprout.left > 0) owed_[name_of_bud(from)] = {sprout.left, sprout.length};
}

/// Returns the unit vector in which a metamer should grow from a bud that points to `bud`.
Vec3 OrganizedTree::wanted_heading(const Growth& growth, MetamerIndex from, Vec3 bud) const {
  const OrganizeParameters& parameters = species_->parameters;
  const bool is_first_of_lateral = growth.sprout.is_lateral && from == growth.sprout.from;
  const DirectionWeights& weights = growth.rank == 0 && parameters.stem ? *parameters.stem : parameters.direction;
  const double steps = weights.fades_by_order ? growth.rank : growth.iteration - 1;
  const double up = weights.up_later + (weights.up - weights.up_later) * math::pow(weights.up_fade, steps);
  const Directions& directions = species_->directions;
  const Vec3 position = root_ + metamers_.tip[from];
  const Vec3 straight_up = -directions.gravity(position).vector();
  const DVec3 light = DVec3(growth.sprout.way) + DVec3(directions.light_sense().given_at(position));
  DVec3 sum = weights.persistence * DVec3(bud) + weights.light * light + up * DVec3(straight_up);
  if (is_first_of_lateral && metamers_.terminal[from].is_damaged()) {
    sum += parameters.takeover * DVec3(metamers_.heading(from));
  }
  if (growth.sprout.is_water_shoot) sum += parameters.water_shoots->up * DVec3(straight_up);
  if (growth.tie != 0) sum += ties_.weight(growth.tie) * DVec3(ties_.way(growth.tie, metamers_.tip[from]));
  return normalized_or(Vec3(sum), bud);
}

/// Returns the desired heading with jitter, or a nearby heading if an obstacle blocks it. Returns nothing if all
/// headings are blocked, or if the heading leads into the ground, where shoots end.
std::optional<Vec3> OrganizedTree::free_heading(MetamerIndex from, Vec3 wanted, float length, RandomKey key,
                                                double jitter) const {
  const Vec3 across = any_perpendicular(wanted);
  for (int k = 0; k < kTries; ++k) {
    const double turn = k == 0 ? jitter * key.normal(0) : kTryTurn * k;
    const double about = 2 * kPi * key.uniform(1 + static_cast<std::uint64_t>(k));
    const Vec3 heading = rotation(rotation(wanted, about) * across, turn) * wanted;
    const Vec3 to = metamers_.tip[from] + length * heading;
    if (to.y < 0 && to.y < metamers_.tip[from].y) {
      if (from != 0) return std::nullopt;
      continue;  // a seed may point along the ground
    }
    if (is_open(metamers_.tip[from], to)) return heading;
  }
  return std::nullopt;
}

/// Returns the direction of the next lateral bud, rotated about the axis from bud to bud. The first bud of a branch
/// points sideways, at right angles to branch and parent.
Vec3 OrganizedTree::next_side(MetamerIndex from, bool is_lateral, std::uint32_t number, Vec3 heading,
                              RandomKey key) const {
  const Phyllotaxis& phyllotaxis = species_->parameters.phyllotaxis;
  Vec3 side = metamers_.side[from];
  double turn = 0;
  if (is_lateral) {
    side = glm::cross(heading, metamers_.heading(from));
  } else if (phyllotaxis.kind == Phyllotaxis::Kind::spiral) {
    turn = phyllotaxis.divergence;
  } else {
    turn = phyllotaxis.kind == Phyllotaxis::Kind::decussate && number % 2 != 0 ? kPi / 2 : kPi;
  }
  side = normalized_or(side - glm::dot(side, heading) * heading, any_perpendicular(heading));
  return rotation(heading, turn + phyllotaxis.jitter * key.child("side").normal(0)) * side;
}

/// Returns true if no obstacle is at `to` or on the way to it and if buds can perceive and may live there. Positions
/// are relative to the root.
bool OrganizedTree::is_open(Vec3 from, Vec3 to) const {
  if (!senses_->reaches(root_ + to) || !stays_in_room(from, to)) return false;
  const Obstacles& obstacles = species_->scene.obstacles;
  if (obstacles.empty()) return true;
  const Vec3 begin = from == Vec3(0) ? 0.001F * to : from;
  return !(obstacles.cross(root_ + begin, root_ + to) || obstacles.contain(root_ + to));
}

/// Returns true unless a shoot would leave the room. With markers, a stem outside may grow toward the room.
bool OrganizedTree::stays_in_room(Vec3 from, Vec3 to) const {
  if (!room_ || room_->contains(to)) return true;
  if (species_->parameters.light.kind == BudLightModel::Kind::shadow || room_->contains(from)) return false;
  return room_->distance(to) < room_->distance(from);
}

void OrganizedTree::shed(int iteration) {
  const BranchShedding& shedding = species_->parameters.shedding;
  if (shedding.below <= 0 && shedding.resource <= 0) return;
  // The light at the begin of the round is divided by the current number of metamers, including those just grown. With
  // this rule, the share of metamers kept agrees with the published values (81 % at a threshold of 0.1, 43 % at 0.3).
  std::vector<std::uint32_t> borne(metamers_.count(), 1);
  for (std::size_t metamer = metamers_.count(); metamer-- > 1;) borne[metamers_.parent[metamer]] += borne[metamer];
  std::vector<std::uint8_t> gone(metamers_.count(), 0);
  bool any = false;
  for (MetamerIndex metamer = 1; metamer < flow_.light.size(); ++metamer) {
    if (!metamers_.begins_shoot(metamer) || metamers_.birth[metamer] + shedding.after >= iteration) continue;
    const bool has_light = flow_.light[metamer] >= shedding.below * borne[metamer];
    if (has_light && flow_.resource[metamer] >= shedding.resource * borne[metamer]) continue;
    gone[metamer] = 1;
    any = true;
  }
  if (!any) return;
  const LossReason why{LossCause::shed, species_->path("shedding")};
  for (MetamerIndex metamer = 1; metamer < metamers_.count(); ++metamer) {
    if (gone[metamer] != 0 && !metamers_.is_loose(metamer)) cut_off(metamer, Bud::dead(), iteration, why);
  }
  clear_away();
}

void OrganizedTree::cut_off(MetamerIndex first, const BudsLeft& after, int iteration, const LossReason& why) {
  if (species_->parameters.request.has(TracePart::losses)) record_loss(first, iteration, why);
  if (species_->parameters.keeps_fallen) fallen_.note(metamers_, first, iteration);
  tree_.cut_off(first, after);
}

void OrganizedTree::record_loss(MetamerIndex first, int iteration, const LossReason& why) {
  TracedLoss& loss = losses_.emplace_back();
  loss.step = iteration;
  loss.why = why;
  loss.position = root_ + metamers_.tip[metamers_.parent[first]];
  for (const MetamerIndex metamer : metamers_.with_borne(first)) {
    loss.segments.push_back({root_ + metamers_.tip[metamers_.parent[metamer]], root_ + metamers_.tip[metamer]});
    loss.length += metamers_.length(metamer);
  }
}

void OrganizedTree::record_ways(const std::vector<Sprout>& sprouts, Flush flush) {
  if (flush != Flush::rest) ways_.clear();
  for (const Sprout& sprout : sprouts) {
    if (sprout.way == Vec3(0)) continue;
    const Vec3 from = root_ + metamers_.tip[sprout.from];
    ways_.push_back({from, from + sprout.way});
  }
}

/// Removes everything that was cut off, also from the data of the current iteration. Returns true if anything was
/// removed.
bool OrganizedTree::clear_away() {
  const std::vector<std::uint8_t> gone = tree_.clear_away();
  if (gone.empty()) return false;
  forget(gone);
  return true;
}

void OrganizedTree::forget(const std::vector<std::uint8_t>& gone) {
  if (species_->parameters.keeps_fallen) fallen_.forget(gone);
  wood_.remove(gone);
  crop_.remove(gone);
  if (!is_pruned()) return;
  std::erase_if(stubs_, [&](const Stub& stub) { return gone[stub.from] != 0; });
  std::vector<MetamerIndex> before(stubs_.empty() ? 0 : gone.size());  // number of removed metamers before each
  for (std::size_t k = 1; k < before.size(); ++k) before[k] = before[k - 1] + gone[k - 1];
  for (Stub& stub : stubs_) stub.from -= before[stub.from];
  upkeep_.bows.remove(gone);
  if (!upkeep_.ringed.empty()) {
    upkeep_.ringed.resize(gone.size(), 0);
    upkeep_.ringed_until.resize(gone.size(), 0);
    erase_marked(upkeep_.ringed, gone);
    erase_marked(upkeep_.ringed_until, gone);
  }
  upkeep_.wounds.remove(gone);
  erase_marked(flow_.light, gone);
  erase_marked(flow_.buds, gone);
  erase_marked(flow_.resource, gone);
  erase_marked(flow_.to_lateral, gone);
  erase_marked(flow_.passed_back, gone);
}

/// Grows the stubs that operations have left.
void OrganizedTree::leave_stubs() {
  for (const Stub& stub : std::exchange(stubs_, {})) {
    const Bud bud = (stub.is_lateral ? metamers_.lateral : metamers_.terminal)[stub.from];
    if (!bud.is_grown()) tree_.leave_stub(stub.from, stub.is_lateral, stub.tip, stub.lost);
  }
}

namespace {

void write_marks(const std::vector<Metamers::Axis>& axes, const std::vector<std::string>& words, Skeleton& skeleton) {
  const auto write = [&](const std::string& name, std::uint32_t bits) {
    std::vector<float>& column = skeleton.extra[name];
    column.resize(skeleton.node_count());
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      column[node] = (axes[skeleton.axis[node]].marks & bits) != 0 ? 1 : 0;
    }
  };
  write("marked", ~0U);
  for (std::size_t k = 0; k < words.size(); ++k) write("mark_" + words[k], 1U << k);
}

}  // namespace

Skeleton OrganizedTree::take_skeleton(const Progress& progress) {
  Skeleton skeleton = skeleton_of(tree_.take_metamers(), std::move(records_), progress);
  if (species_->parameters.keeps_fallen) return fallen_.with_fallen(std::move(skeleton), species_->parameters.radii);
  return skeleton;
}

Skeleton OrganizedTree::skeleton(const Progress& progress) const { return skeleton_of(metamers_, records_, progress); }

Skeleton OrganizedTree::skeleton_of(Metamers metamers, std::vector<OperationRecord> records,
                                    const Progress& progress) const {
  const std::vector<std::uint16_t> ranks = is_pruned() ? find_leads(metamers).rank : std::vector<std::uint16_t>();
  const std::size_t count = metamers.count();
  Skeleton skeleton;
  skeleton.position.resize(count);
  std::vector<float>& angle = skeleton.extra[std::string(kBudAngleColumn)];
  angle.resize(count);
  parallel_for(count, kMetamersPerBlock, [&](std::size_t begin, std::size_t end) {
    progress.check();
    for (auto metamer = static_cast<MetamerIndex>(begin); metamer < end; ++metamer) {
      skeleton.position[metamer] = root_ + metamers.tip[metamer];
      const Frame frame = frame_along(Vec3(0), metamers.heading(metamer), kUp);
      const Vec3 side = metamers.side[metamer];
      angle[metamer] = static_cast<float>(math::atan2(glm::dot(side, frame.right()), glm::dot(side, frame.upper())));
    }
  });
  skeleton.parent = std::move(metamers.parent);
  skeleton.radius.assign(count, 0);
  skeleton.axis = std::move(metamers.axis);
  skeleton.order = std::move(metamers.order);
  skeleton.birth.assign(metamers.birth.begin(), metamers.birth.end());
  skeleton.extra[std::string(kMetamerColumn)].assign(metamers.number.begin(), metamers.number.end());
  skeleton.extra["light"].assign(flow_.light.begin(), flow_.light.end());
  skeleton.extra["resource"].assign(flow_.resource.begin(), flow_.resource.end());
  std::vector<float>& to_lateral = skeleton.extra["lateral_resource"];
  to_lateral.resize(count);
  for (MetamerIndex metamer = 0; metamer < count; ++metamer) {
    to_lateral[metamer] = static_cast<float>(flow_.lateral(metamer));
  }
  const auto states = [&](const std::vector<Bud>& buds) {
    std::vector<float> column(count);
    std::ranges::transform(buds, column.begin(), [](Bud bud) { return static_cast<float>(bud.state()); });
    return column;
  };
  skeleton.extra[std::string(kTerminalBudColumn)] = states(metamers.terminal);
  skeleton.extra[std::string(kLateralBudColumn)] = states(metamers.lateral);
  skeleton.extra[std::string(kShedColumn)] = std::move(metamers.lost_tips);
  if (species_->parameters.bearing) crop_.write(skeleton);
  if (is_pruned()) {
    upkeep_.wounds.write(skeleton, species_->parameters.closure, iteration_ - 1);
    write_marks(metamers.axes, species_->parameters.marks, skeleton);
    for (OperationRecord& record : records) {
      record.position += root_;
      record.bud_position += root_;
    }
    skeleton.operations = OperationRecords(std::move(records));
    std::vector<float>& rank = skeleton.extra["rank"];
    rank.resize(count);
    for (MetamerIndex metamer = 0; metamer < count; ++metamer) rank[metamer] = ranks.at(skeleton.axis[metamer]);
    if (species_->parameters.plans && !is_outcome_) {
      std::vector<float>& plan_cut = skeleton.extra["plan_cut"];
      plan_cut.assign(plan_cuts_.begin(), plan_cuts_.end());
      plan_cut.resize(count, 0);
    }
  }
  progress.check();
  assign_pipe_radii(skeleton, species_->parameters.radii);
  wood_.thicken(skeleton, species_->parameters.radii);
  upkeep_.wounds.swell(species_->parameters.callus, skeleton);
  return skeleton;
}

Vec3 bud_side(Vec3 heading, double bud_angle) {
  const Frame frame = frame_along(Vec3(0), heading, kUp);
  return static_cast<float>(math::sin(bud_angle)) * frame.right() +
         static_cast<float>(math::cos(bud_angle)) * frame.upper();
}

}  // namespace meristem
