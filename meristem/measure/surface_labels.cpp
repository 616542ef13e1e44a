// SPDX-License-Identifier: Apache-2.0
// Labels positions on surfaces with tree, component, instance and shoot. The facts of each plant are found once, in the
// plant's own numbering, also for each variant that stands in several places. For each place, the numbers of everything
// before it are added, in the order in which the plant would be copied out (plant_variant.h). No plant is copied.
#include "meristem/measure/surface_labels.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <glm/matrix.hpp>

#include "meristem/base/parallel.h"
#include "meristem/plant/axis_labels.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/plant/segment_tree.h"
#include "meristem/shape/stem/body_meshes.h"

namespace meristem {

namespace {

constexpr std::size_t kOrgansPerSearch = 512;

/// A shoot in the numbering of its plant.
struct ShootFacts {
  std::uint32_t tree = 0;
  std::uint32_t instance = 0;
  std::uint32_t component = 0;  // index into PlantFacts::components
  std::uint16_t order = 0;
};

struct OrganFacts {
  std::uint32_t instance = 0;
  std::uint32_t shoot = kNoShoot;
};

/// The facts of one plant, without the plants placed in it.
struct PlantFacts {
  std::vector<std::uint32_t> first_shoot{};  // for each stem its first shoot, and last the number of shoots
  std::vector<ShootFacts> shoots{};
  std::uint32_t trees = 0;
  std::vector<std::string> components{};                // ids of the stems' parts and of the prototypes
  std::vector<std::uint32_t> prototype_component{};     // component of each prototype
  std::vector<std::vector<OrganFacts>> of_prototype{};  // organs of each prototype
  std::vector<std::uint32_t> stem_instances{};          // for each component: the highest number of an instance plus
                                                        // one
  std::vector<std::uint32_t> organ_instances{};         // for each component
  std::optional<SegmentTree> segments{};                // finds the axes of bodies; set after the organs are known, and
                                                        // only if there are bodies
  std::vector<std::string> labels{};                    // label of each shoot

  std::uint32_t number_of(const std::string& component) {
    const auto found = std::find(components.begin(), components.end(), component);
    if (found != components.end()) return static_cast<std::uint32_t>(found - components.begin());
    components.push_back(component);
    stem_instances.push_back(0);
    organ_instances.push_back(0);
    return static_cast<std::uint32_t>(components.size() - 1);
  }
};

void add_shoots(const Stem& stem, PlantFacts& facts) {
  const Skeleton& skeleton = stem.skeleton;
  const auto first = static_cast<std::uint32_t>(facts.shoots.size());
  std::vector<std::uint32_t> component_of_part;
  for (const StemPart& part : stem.parts) {
    const std::uint32_t component = facts.number_of(part.component);
    component_of_part.push_back(component);
    facts.stem_instances[component] = std::max(facts.stem_instances[component], part.instance + 1);
  }
  std::uint32_t next_tree = facts.trees;
  std::vector<bool> is_known;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const AxisIndex axis = skeleton.axis[node];
    const NodeIndex parent = skeleton.parent[node];
    const std::uint32_t own_tree = parent == kNoNode ? next_tree++ : 0;
    if (axis >= is_known.size()) {
      is_known.resize(std::size_t{axis} + 1);
      facts.shoots.resize(std::size_t{first} + axis + 1);
    }
    if (is_known[axis]) continue;
    is_known[axis] = true;
    const std::size_t part = stem.part_index(axis);
    facts.shoots[first + axis] = {parent == kNoNode ? own_tree : facts.shoots[first + skeleton.axis[parent]].tree,
                                  stem.parts[part].instance, component_of_part[part], skeleton.order[node]};
  }
  facts.trees = next_tree;
}

PlantFacts shoots_of(const Plant& plant, const Progress& progress) {
  PlantFacts facts;
  std::vector<RoundSegment> segments;
  for (const Stem& stem : plant.stems) {
    progress.check();
    facts.first_shoot.push_back(static_cast<std::uint32_t>(facts.shoots.size()));
    append_segments(stem.skeleton, facts.first_shoot.back(), segments);
    add_shoots(stem, facts);
    std::vector<std::string> labels = axis_labels(stem.skeleton);
    labels.resize(facts.shoots.size() - facts.first_shoot.back());
    std::move(labels.begin(), labels.end(), std::back_inserter(facts.labels));
  }
  facts.first_shoot.push_back(static_cast<std::uint32_t>(facts.shoots.size()));
  facts.segments.emplace(std::move(segments), progress);
  for (const OrganPrototype& prototype : plant.prototypes) {
    facts.prototype_component.push_back(facts.number_of(prototype.component));
  }
  return facts;
}

/// Finds the shoot of each organ, and lists the shoots by prototype.
void find_shoots_of_organs(const Plant& plant, PlantFacts& facts, Progress& progress) {
  std::vector<std::uint32_t> shoots(plant.organs.size(), kNoShoot);
  parallel_for(shoots.size(), kOrgansPerSearch, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t nearest = facts.segments->nearest(plant.organs[k].frame.origin);
      if (nearest != kNoSegment) shoots[k] = nearest;
    }
    progress.advance(end - begin);
  });
  facts.of_prototype.resize(plant.prototypes.size());
  for (std::size_t k = 0; k < shoots.size(); ++k) {
    const std::uint32_t prototype = plant.organs[k].prototype;
    std::uint32_t& next = facts.organ_instances[facts.prototype_component[prototype]];
    facts.of_prototype[prototype].push_back({next++, shoots[k]});
  }
}

PlantFacts facts_of(const Plant& plant, Progress& progress) {
  PlantFacts facts = shoots_of(plant, progress);
  find_shoots_of_organs(plant, facts, progress);
  if (!has_bodies(plant)) facts.segments.reset();
  return facts;
}

/// Appends a plant and all plants placed in it. Each plant is appended once.
void gather(const Plant& plant, std::unordered_set<const Plant*>& known, std::vector<const Plant*>& plants) {
  if (!known.insert(&plant).second) return;
  plants.push_back(&plant);
  for (const Planting& planting : plant.plantings) gather(*planting.variant->plant, known, plants);
}

/// A plant on one place, and the counts of everything before this place.
struct PlaceFacts {
  const PlantFacts* facts = nullptr;  // facts of the plant on this place
  std::uint32_t shoots = 0;
  std::uint32_t trees = 0;
  std::vector<std::uint32_t> stem_instances{};   // for each component of the variant
  std::vector<std::uint32_t> organ_instances{};  // for each component of the variant
  std::vector<std::vector<PlaceFacts>> inner{};  // places of each planting of the variant
};

}  // namespace

struct LabelFacts {
  const MeshScene* scene = nullptr;
  std::unordered_map<const Plant*, PlantFacts> of_plant;
  PlaceFacts root;
  std::uint32_t shoots = 0;
  std::vector<std::string> components;
  std::vector<std::uint32_t> component_of_part;

  /// The plant, on one of its places, to which the shoots from `first` on belong.
  struct Owner {
    std::uint32_t first = 0;
    const PlantFacts* facts = nullptr;
    std::shared_ptr<const std::string> prefix;  // prefix of the component ids
  };
  std::vector<Owner> owners;

  const Owner& owner(std::uint32_t shoot) const {
    const auto after = std::upper_bound(owners.begin(), owners.end(), shoot,
                                        [](std::uint32_t wanted, const Owner& of) { return wanted < of.first; });
    return *(after - 1);
  }

  /// Counts of everything that comes before the current place.
  struct Counts {
    std::uint32_t shoots = 0;
    std::uint32_t trees = 0;
    std::map<std::string, std::uint32_t, std::less<>> stem_instances;
    std::map<std::string, std::uint32_t, std::less<>> organ_instances;
  };

  void find(const Plant& plant, Progress& progress) {
    std::unordered_set<const Plant*> known;
    std::vector<const Plant*> plants;
    gather(plant, known, plants);
    std::uint64_t organs = 0;
    for (const Plant* own : plants) organs += own->organs.size();
    progress.begin("labelling", organs);
    for (const Plant* own : plants) of_plant.emplace(own, facts_of(*own, progress));
  }

  /// Recursion is safe: the readers of documents limit the depth of plantings.
  PlaceFacts place(const Plant& own, const std::shared_ptr<const std::string>& prefix, Counts& counts,
                   const Progress& progress) {
    progress.check();
    const PlantFacts& facts = of_plant.at(&own);
    if (!facts.shoots.empty()) owners.push_back({counts.shoots, &facts, prefix});
    PlaceFacts made{.facts = &facts, .shoots = counts.shoots, .trees = counts.trees};
    counts.shoots += static_cast<std::uint32_t>(facts.shoots.size());
    counts.trees += facts.trees;
    for (std::size_t k = 0; k < facts.components.size(); ++k) {
      const std::string name = *prefix + facts.components[k];
      std::uint32_t& stems = counts.stem_instances[name];
      std::uint32_t& organs = counts.organ_instances[name];
      made.stem_instances.push_back(stems);
      made.organ_instances.push_back(organs);
      stems += facts.stem_instances[k];
      organs += facts.organ_instances[k];
    }
    for (const Planting& planting : own.plantings) {
      std::vector<PlaceFacts>& places = made.inner.emplace_back();
      const auto inner = std::make_shared<const std::string>(*prefix + planting.component + ".");
      for (std::size_t k = 0; k < planting.places.size(); ++k) {
        places.push_back(place(*planting.variant->plant, inner, counts, progress));
      }
    }
    return made;
  }

  void name_components() {
    std::unordered_map<std::string_view, std::uint32_t> known;
    for (const MeshInstances& part : scene->meshes) {
      const auto [found, is_new] = known.try_emplace(part.component, static_cast<std::uint32_t>(components.size()));
      if (is_new) components.push_back(part.component);
      component_of_part.push_back(found->second);
    }
    components.emplace_back("ground");
  }
};

PlantLabels::PlantLabels(const Plant& plant, const SizeLimits& limits, Progress& progress)
    : facts_(std::make_unique<LabelFacts>()) {
  std::optional<Plant> copied;
  // The meshes are made from this copy as well.
  if (has_deformed_plantings(plant)) copied = with_deformed_copies(plant, limits, progress);
  const Plant& labelled = copied ? *copied : plant;
  facts_->find(labelled, progress);
  LabelFacts::Counts counts;
  facts_->root = facts_->place(labelled, std::make_shared<const std::string>(), counts, progress);
  facts_->shoots = counts.shoots;
}

PlantLabels::PlantLabels(PlantLabels&&) noexcept = default;
PlantLabels::~PlantLabels() = default;

SurfaceLabels::SurfaceLabels(PlantLabels&& labels, const MeshScene& scene) {
  labels.facts_->scene = &scene;
  labels.facts_->name_components();
  facts_ = std::move(labels.facts_);
}

SurfaceLabels::SurfaceLabels(const Plant& plant, const SizeLimits& limits, const MeshScene& scene, Progress& progress)
    : SurfaceLabels(PlantLabels(plant, limits, progress), scene) {}

SurfaceLabels::~SurfaceLabels() = default;

SurfaceLabel SurfaceLabels::of(std::uint32_t part, std::uint32_t instance, std::uint32_t triangle,
                               Vec3 position) const {
  const MeshInstances& mesh = facts_->scene->meshes[part];
  SurfaceLabel label{.kind = SurfaceKind::obstacle, .component = facts_->component_of_part[part]};
  const MeshOrigin* origin = mesh.origin.get();
  if (origin == nullptr) return label;

  // Descend to the place, and to the plant that has the mesh.
  const auto frames = static_cast<std::uint32_t>(mesh.frames.size());
  const std::uint32_t frame = instance % frames;
  std::size_t place_number = instance / frames;
  std::size_t deeper = mesh.place_count();
  const PlaceFacts* place = &facts_->root;
  if (mesh.places != nullptr && origin->inner != nullptr) {
    const Frame& to_world = (*mesh.places)[place_number];
    position = glm::inverse(to_world.axes) * (position - to_world.origin);
  }
  while (origin->planting != kNoNumber) {
    const std::vector<PlaceFacts>& places = place->inner[origin->planting];
    deeper /= places.size();
    place = &places[place_number / deeper];
    place_number %= deeper;
    origin = origin->inner.get();
  }
  const PlantFacts& facts = *place->facts;
  const auto set_shoot = [&](std::uint32_t shoot) {
    label.tree = place->trees + facts.shoots[shoot].tree;
    label.shoot = place->shoots + shoot;
    label.order = facts.shoots[shoot].order;
  };

  if (origin->prototype != kNoNumber) {
    const OrganFacts& organ = facts.of_prototype[origin->prototype][frame];
    label.kind = SurfaceKind::organ;
    label.instance = place->organ_instances[facts.prototype_component[origin->prototype]] + organ.instance;
    if (organ.shoot != kNoShoot) set_shoot(organ.shoot);
    return label;
  }
  label.kind = SurfaceKind::wood;
  std::uint32_t shoot = kNoShoot;
  if (origin->tubes != nullptr) {
    const auto after =
        std::upper_bound(origin->tubes->begin(), origin->tubes->end(), triangle,
                         [](std::uint32_t wanted, const AxisTriangles& of) { return wanted < of.first; });
    shoot = facts.first_shoot[origin->stem] + (after - 1)->axis;
  } else {
    shoot = facts.segments->nearest(position);
    if (shoot == kNoSegment) shoot = facts.first_shoot[origin->stem];
  }
  set_shoot(shoot);
  label.instance = place->stem_instances[facts.shoots[shoot].component] + facts.shoots[shoot].instance;
  return label;
}

const std::vector<std::string>& SurfaceLabels::components() const { return facts_->components; }

std::uint32_t SurfaceLabels::shoot_count() const { return facts_->shoots; }

const std::string& SurfaceLabels::shoot_label(std::uint32_t shoot) const {
  const LabelFacts::Owner& owner = facts_->owner(shoot);
  return owner.facts->labels[shoot - owner.first];
}

ShootOrigin SurfaceLabels::shoot_origin(std::uint32_t shoot) const {
  const LabelFacts::Owner& owner = facts_->owner(shoot);
  const ShootFacts& facts = owner.facts->shoots[shoot - owner.first];
  return {*owner.prefix + owner.facts->components[facts.component], facts.order};
}

}  // namespace meristem
