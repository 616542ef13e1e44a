// SPDX-License-Identifier: Apache-2.0
// Copies of planted variants. A variant may have plantings of its own: a list of pending variants, each with its frame,
// replaces recursion. The reader of documents limits the depth.
#include "meristem/plant/plant_variant.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <span>

#include <glm/matrix.hpp>

#include "meristem/base/math.h"
#include "meristem/base/random.h"
#include "meristem/plant/deform_plant.h"
#include "meristem/plant/operation_record.h"
#include "meristem/plant/plant.h"

namespace meristem {

namespace {

/// Numbers of a plant as doubles, because nested plantings multiply them.
struct Totals {
  double stems = 0;
  double nodes = 0;
  double organs = 0;
};

/// Counts the stems, nodes and organs of a plant with all plantings copied out. `known` caches the counts of variants.
Totals totals_of(const Plant& plant, std::map<const PlantVariant*, Totals>& known) {
  Totals sum{static_cast<double>(plant.stems.size()), static_cast<double>(plant.node_count()),
             static_cast<double>(plant.organs.size())};
  for (const Planting& planting : plant.plantings) {
    auto found = known.find(planting.variant.get());
    if (found == known.end()) {
      const Totals own = totals_of(*planting.variant->plant, known);
      found = known.emplace(planting.variant.get(), own).first;
    }
    sum.stems += static_cast<double>(planting.places.size()) * found->second.stems;
    sum.nodes += static_cast<double>(planting.places.size()) * found->second.nodes;
    sum.organs += static_cast<double>(planting.places.size()) * found->second.organs;
  }
  return sum;
}

void check_totals(const Plant& plant, const SizeLimits& limits) {
  std::map<const PlantVariant*, Totals> known;
  const Totals sum = totals_of(plant, known);
  const std::string path = "components." + plant.plantings.front().component;
  if (sum.nodes > static_cast<double>(limits.nodes)) {
    throw_limit("nodes, each placed plant counted,", sum.nodes, limits.nodes, "nodes", path);
  }
  if (sum.organs > static_cast<double>(limits.instances)) {
    throw_limit("organs, each placed plant counted,", sum.organs, limits.instances, "instances", path);
  }
}

void move(Skeleton& skeleton, const Frame& frame) {
  for (Vec3& position : skeleton.position) position = frame.point(position);
  const auto scale = static_cast<float>(math::pow(std::abs(glm::determinant(frame.axes)), 1.0 / 3));
  for (float& radius : skeleton.radius) radius *= scale;
  for (OperationRecord& record : skeleton.operations) move_record(record, frame, scale);
}

void move(Stem& stem, const Frame& frame) {
  move(stem.skeleton, frame);
  if (stem.undeformed == nullptr) return;
  Skeleton undeformed = *stem.undeformed;
  move(undeformed, frame);
  stem.undeformed = std::make_shared<const Skeleton>(std::move(undeformed));
  for (StemPart& part : stem.parts) {
    if (part.deformation != nullptr) part.deformation = part.deformation->moved_to(frame);
  }
}

/// The receiver of the blocks of an expansion. Used during one call only.
struct BlockTaker {
  FunctionRef<void(const Plant& block)> take;
  std::size_t block_size = kExpandedBlock;
};

class Expander {
 public:
  /// Expands into `to`, a copy of `own` without its plantings. With `blocks`, `to` begins without stems and organs.
  /// They are passed on block by block and then removed.
  Expander(const Plant& own, Plant& to, const SizeLimits& limits, const Progress& progress,
           const BlockTaker* blocks = nullptr)
      : to_(to), limits_(limits), progress_(progress), blocks_(blocks) {
    for (const Stem& stem : own.stems) {
      for (const StemPart& part : stem.parts) count(part.component, part.instance);
    }
    const bool is_bare = own.stems.empty() && own.organs.empty();
    // The individual of everything outside plantings.
    if (to.individuals.empty() && !is_bare) to.individuals.emplace_back();
    for (std::uint32_t k = 0; k < to.individuals.size(); ++k) {
      individuals_.emplace(std::pair(to.individuals[k].component, to.individuals[k].number), k);
    }
  }

  /// Adds copies of everything on the plantings of a plant whose world lies at `frame`. `row` is the table row that
  /// placed that plant, and `name` is the name of its place.
  void add_plantings(const std::vector<Planting>& plantings, const Frame& frame, const std::string& prefix,
                     std::uint32_t row = kNoRow, RandomKey name = RandomKey()) {
    for (const Planting& planting : plantings) {
      const std::string own = prefix + planting.component;
      const auto deformation = planting.deformation != nullptr ? planting.deformation->moved_to(frame) : nullptr;
      for (const Planting::Place& place : planting.places) {
        progress_.check();
        const std::size_t stems = to_.stems.size(), organs = to_.organs.size();
        const std::uint32_t from = row == kNoRow ? place.row : row;
        Vec3 foot = (frame * place.frame).origin;
        if (deformation != nullptr) deformation->map(std::span(&foot, 1), own);
        individual_ = individual_at(own, place.instance, foot, from);
        if (deformation != nullptr) ++deforming_;
        add(*planting.variant, frame * place.frame, own + ".", place.birth, from, name.child(place.name));
        if (deformation != nullptr) {
          deform_from(stems, organs, deformation);
          --deforming_;
        }
        if (blocks_ != nullptr && deforming_ == 0 && size_ >= blocks_->block_size) give_block();
      }
    }
  }

  /// Passes on everything that was added since the last block.
  void give_block() {
    if (size_ == 0) return;
    blocks_->take(to_);
    to_.stems.clear();
    to_.organs.clear();
    size_ = 0;
  }

 private:
  /// First indices of a variant's materials and prototypes in the result.
  struct Numbers {
    std::uint32_t material = 0;
    std::uint32_t prototype = 0;
  };

  void add(const PlantVariant& variant, const Frame& frame, const std::string& prefix, float birth, std::uint32_t row,
           RandomKey name) {
    const Plant& plant = *variant.plant;
    const std::uint32_t individual = individual_;
    const Numbers first = numbers_of(variant, prefix);
    std::map<std::string, std::uint32_t> next;  // first instance number of each component in this copy
    for (const Stem& stem : plant.stems) {
      Stem& copy = to_.stems.emplace_back(stem);
      move(copy, frame);
      const auto roots = std::ranges::count(copy.skeleton.parent, kNoNode);
      copy.individual_of_root.assign(static_cast<std::size_t>(roots), individual);
      for (float& own : copy.skeleton.birth) own += birth;
      for (std::uint64_t& own : copy.axis_names) own = name.child(own).bits();
      for (StemPart& part : copy.parts) {
        part.component = prefix + part.component;
        part.material += first.material;
        part.instance += next.try_emplace(part.component, instances_[part.component]).first->second;
      }
    }
    for (std::size_t k = to_.stems.size() - plant.stems.size(); k < to_.stems.size(); ++k) {
      for (const StemPart& part : to_.stems[k].parts) count(part.component, part.instance);
    }
    for (Organ organ : plant.organs) {
      organ.frame = frame * organ.frame;
      organ.prototype += first.prototype;
      organ.birth += birth;
      organ.individual = individual;
      organ.name = name.child(organ.name).bits();
      to_.organs.push_back(organ);
    }
    size_ += plant.node_count() + plant.organs.size();
    add_plantings(plant.plantings, frame, prefix, row, name);
  }

  /// Deforms the stems and organs with indices from `stems` and `organs` on.
  void deform_from(std::size_t stems, std::size_t organs, const std::shared_ptr<const Deformation>& deformation) {
    for (std::size_t k = stems; k < to_.stems.size(); ++k) {
      deform(to_.stems[k], std::vector(to_.stems[k].parts.size(), deformation));
    }
    const DeformedOrgans row{organs, to_.organs.size() - organs, deformation};
    const std::size_t prototypes = to_.prototypes.size();
    deform_organs(to_, std::span(&row, 1), mesh_bytes_, limits_, progress_);
    for (std::size_t k = prototypes; k < to_.prototypes.size(); ++k) mesh_bytes_ += to_.prototypes[k].mesh->bytes();
  }

  /// Returns the numbers of a variant's materials and prototypes. Adds them once for each path of component ids.
  Numbers numbers_of(const PlantVariant& variant, const std::string& prefix) {
    const auto [found, is_new] = numbers_.try_emplace({&variant, prefix});
    if (!is_new) return found->second;
    found->second = {static_cast<std::uint32_t>(to_.materials.size()),
                     static_cast<std::uint32_t>(to_.prototypes.size())};
    for (Material material : variant.materials()) {
      material.name = prefix + material.name;
      to_.materials.push_back(std::move(material));
    }
    for (OrganPrototype prototype : variant.plant->prototypes) {
      prototype.component = prefix + prototype.component;
      prototype.material += found->second.material;
      to_.prototypes.push_back(std::move(prototype));
    }
    return found->second;
  }

  /// Returns the individual at a place, and adds it if it is new. A component of the document keeps its instance
  /// number; nested components are numbered in order.
  std::uint32_t individual_at(const std::string& component, std::uint32_t instance, Vec3 foot, std::uint32_t row) {
    const auto next = static_cast<std::uint32_t>(to_.individuals.size());
    const std::uint32_t number = component.find('.') == std::string::npos ? instance : nested_[component]++;
    const auto [known, is_new] = individuals_.try_emplace({component, number}, next);
    if (is_new) to_.individuals.push_back({.component = component, .number = number, .foot = foot, .row = row});
    return known->second;
  }

  void count(const std::string& component, std::uint32_t instance) {
    std::uint32_t& next = instances_[component];
    next = std::max(next, instance + 1);
  }

  Plant& to_;
  const SizeLimits& limits_;
  const Progress& progress_;
  const BlockTaker* blocks_;      // null: everything stays in the plant
  std::uint64_t size_ = 0;        // nodes and organs since the last block
  int deforming_ = 0;             // number of deformed places around the added plant
  std::uint64_t mesh_bytes_ = 0;  // bytes of the deformed meshes
  std::map<std::pair<const PlantVariant*, std::string>, Numbers> numbers_;
  std::map<std::string, std::uint32_t> instances_;                              // the next number of each component
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> individuals_;  // by component and number
  std::map<std::string, std::uint32_t> nested_;  // the next number of plants inside placed plants
  std::uint32_t individual_ = 0;                 // individual of the stems and organs that are being added
};

}  // namespace

const std::vector<Material>& PlantVariant::materials() const {
  return painted != nullptr ? *painted : plant->materials;
}

std::uint64_t PlantVariant::bytes() const {
  std::uint64_t sum = plant->organs.size() * sizeof(Organ);
  for (const Stem& stem : plant->stems) sum += stem.skeleton.node_count() * 40;
  return sum;
}

bool has_plantings(const Plant& plant) { return !plant.plantings.empty(); }

Plant expanded(const Plant& plant, const SizeLimits& limits, const Progress& progress) {
  if (has_plantings(plant)) check_totals(plant, limits);
  Plant all = plant;
  all.plantings.clear();
  const PlantTotals totals = totals_of(plant);
  all.stems.reserve(totals.stems);
  all.organs.reserve(totals.organs);
  Expander(plant, all, limits, progress).add_plantings(plant.plantings, Frame{}, "");
  return all;
}

std::vector<Individual> expand_in_blocks(const Plant& plant, const SizeLimits& limits, const Progress& progress,
                                         FunctionRef<void(const Plant& block)> take, std::size_t block_size) {
  if (has_plantings(plant)) check_totals(plant, limits);
  take(plant);
  if (!has_plantings(plant)) return plant.individuals;
  Plant block;
  block.materials = plant.materials;
  block.prototypes = plant.prototypes;
  block.individuals = plant.individuals;
  const BlockTaker blocks{take, block_size};
  Expander expander(plant, block, limits, progress, &blocks);
  expander.add_plantings(plant.plantings, Frame{}, "");
  expander.give_block();
  return std::move(block.individuals);
}

namespace {

bool is_deformed(const Planting& planting) { return planting.deformation != nullptr; }

}  // namespace

bool has_deformed_plantings(const Plant& plant) { return std::ranges::any_of(plant.plantings, is_deformed); }

Plant with_deformed_copies(const Plant& plant, const SizeLimits& limits, const Progress& progress) {
  Plant deformed = plant;
  std::erase_if(deformed.plantings, [](const Planting& planting) { return !is_deformed(planting); });
  deformed = expanded(deformed, limits, progress);
  std::ranges::copy_if(plant.plantings, std::back_inserter(deformed.plantings),
                       [](const Planting& planting) { return !is_deformed(planting); });
  return deformed;
}

PlantTotals totals_of(const Plant& plant) {
  std::map<const PlantVariant*, Totals> known;
  const Totals sum = totals_of(plant, known);
  const auto whole = [](double count) { return count < 1e19 ? static_cast<std::uint64_t>(count) : ~std::uint64_t{0}; };
  return {whole(sum.stems), whole(sum.nodes), whole(sum.organs)};
}

ExpandedPlant::ExpandedPlant(const Plant& plant, const SizeLimits& limits, const Progress& progress) : plant_(&plant) {
  if (!has_plantings(plant)) return;
  made_ = std::make_shared<const Plant>(expanded(plant, limits, progress));
  plant_ = made_.get();
}

}  // namespace meristem
