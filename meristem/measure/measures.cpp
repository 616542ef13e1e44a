// SPDX-License-Identifier: Apache-2.0
// Measures stands and plants. Each tree is recorded alone (stand_sum.h), then sums and samples are combined for the
// stand. Plants arrive in blocks, so placed plants are never copied as a whole.
#include "meristem/measure/measures.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

#include "meristem/base/parallel.h"
#include "meristem/measure/block_light.h"
#include "meristem/measure/masked_surfaces.h"
#include "meristem/measure/stand_sum.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/stem/body_meshes.h"

namespace meristem {
namespace {

/// Appends the individual of each tree of a plant. Each root of each stem is a tree.
void append_individuals_of_trees(const Plant& plant, std::vector<std::uint32_t>& individuals) {
  for (const Stem& stem : plant.stems) {
    const auto& parents = stem.skeleton.parent;
    const auto roots = static_cast<std::size_t>(std::count(parents.begin(), parents.end(), kNoNode));
    for (std::size_t root = 0; root < roots; ++root) {
      individuals.push_back(root < stem.individual_of_root.size() ? stem.individual_of_root[root] : 0);
    }
  }
}

/// Returns the tree of each of `count` individuals, or kNoTree if an individual has no tree or several trees.
std::vector<std::uint32_t> trees_of_individuals(std::size_t count, const std::vector<std::uint32_t>& of_trees) {
  std::vector<std::uint32_t> tree(count, kNoTree);
  std::vector<std::uint32_t> trees(count, 0);
  for (std::uint32_t k = 0; k < of_trees.size(); ++k) {
    if (of_trees[k] >= count) continue;
    tree[of_trees[k]] = k;
    ++trees[of_trees[k]];
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (trees[k] != 1) tree[k] = kNoTree;
  }
  return tree;
}

/// Returns the number of individuals that organs can belong to. A plant without a list of individuals counts as one.
std::size_t individual_count(const std::vector<Individual>& individuals) {
  return std::max<std::size_t>(individuals.size(), 1);
}

/// The leaves, and the light on them if it is known.
struct Leaves {
  FoliageMeasures foliage;
  MeanLight light;

  void tell(Measures& measures) const {
    measures.leaf_count = foliage.leaves;
    measures.leaf_area = foliage.area;
    measures.petiole_area = foliage.petiole_area;
    if (measures.crown_ground_area > 0) measures.leaf_area_index = foliage.area / measures.crown_ground_area;
    const LitOrgan mean = light.mean();
    if (!(mean.area > 0)) return;
    measures.leaf_exposure = mean.exposure;
    measures.leaf_irradiance = mean.irradiance;
  }
};

/// The trees of a stand, in the order of their skeletons.
class TreeList {
 public:
  /// Counts nodes into the caller's stage of `progress`.
  void add(std::span<const Skeleton* const> skeletons, const Scene* scene, const MeasureOptions& options,
           Progress& progress) {
    std::vector<std::vector<TreeRecord>> of_skeleton(skeletons.size());
    parallel_for(skeletons.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        of_skeleton[k] = record_trees(*skeletons[k], scene, options, progress);
        progress.advance(skeletons[k]->node_count());
      }
    });
    for (const std::vector<TreeRecord>& records : of_skeleton) {
      for (const TreeRecord& record : records) add(record);
      ++skeletons_;
    }
  }

  std::vector<TreeOrigin>& origins() { return stand_.origins; }

  StandMeasures finish() {
    stand_.whole = whole_.finish();
    return std::move(stand_);
  }

 private:
  void add(const TreeRecord& record) {
    whole_.add(record);
    StandSum alone;
    alone.add(record);
    stand_.trees.push_back(alone.finish());
    stand_.origins.push_back({.skeleton = skeletons_, .position = record.position});
  }

  StandMeasures stand_;
  StandSum whole_;
  std::size_t skeletons_ = 0;
};

/// Measures the stems and organs of a plant that comes in blocks.
class PlantMeasurer {
 public:
  /// `meshes` is null if light is not measured. The arguments must outlive this object.
  PlantMeasurer(const Scene& scene, const MeasureOptions& options, const MeshScene* meshes, Progress& progress)
      : scene_(scene), options_(options), meshes_(meshes), progress_(progress) {}

  /// Counts nodes and organs into the caller's stage of progress.
  void add(const Plant& block) {
    add_trees(block);
    add_organs(block);
    add_thickening(block, thickening_);
  }

  /// Must be called once, with all individuals of the plant.
  StandMeasures finish(const std::vector<Individual>& individuals) {
    for (std::size_t k = 0; k < trees_.origins().size(); ++k) {
      const std::uint32_t individual = individual_of_tree_[k];
      if (individual < individuals.size()) trees_.origins()[k].row = individuals[individual].row;
    }
    StandMeasures stand = trees_.finish();
    stand.organs = std::move(lit_);
    tell_leaves(individual_count(individuals), stand);
    tell_thickening(stand.whole);
    return stand;
  }

 private:
  void add_trees(const Plant& block) {
    std::vector<const Skeleton*> skeletons;
    for (const Stem& stem : block.stems) skeletons.push_back(&stem.skeleton);
    const std::size_t before = trees_.origins().size();
    trees_.add(skeletons, &scene_, options_, progress_);
    for (std::size_t k = before; k < trees_.origins().size(); ++k) {
      TreeOrigin& origin = trees_.origins()[k];
      const StemPart& root = block.stems[origin.skeleton - stems_].parts.front();
      origin.component = root.component;
      origin.instance = root.instance;
    }
    stems_ += block.stems.size();
    append_individuals_of_trees(block, individual_of_tree_);
  }

  void add_organs(const Plant& block) {
    if (block.organs.empty()) return;
    surfaces_.add_new(block);
    Progress silent(&progress_);
    const std::vector<OrganArea> areas = surfaces_.areas(block, meshes_ == nullptr ? progress_ : silent);
    std::vector<LitOrgan> lit;
    if (meshes_ != nullptr) {
      if (!light_) light_.emplace(*meshes_, scene_, progress_);
      lit = light_->measure(block, areas, progress_);
    }
    of_individual_.resize(std::max(of_individual_.size(), individual_count(block.individuals)));
    for (std::size_t k = 0; k < areas.size(); ++k) {
      if (is_leaf(block, block.organs[k])) add_leaf(block.organs[k], areas[k], lit.empty() ? nullptr : &lit[k]);
    }
    if (options_.organ_list) lit_.insert(lit_.end(), lit.begin(), lit.end());
  }

  void add_leaf(const Organ& leaf, const OrganArea& area, const LitOrgan* lit) {
    const auto add_to = [&](Leaves& leaves) {
      leaves.foliage.add(area);
      if (lit != nullptr) leaves.light.add(*lit);
    };
    add_to(leaves_);
    if (leaf.individual < of_individual_.size()) add_to(of_individual_[leaf.individual]);
    are_apart_ = are_apart_ && leaf.individual != kNoIndividual;
  }

  /// Sets the leaf measures of the stand. Sets the leaf measures of each tree only if no leaf belongs to several trees.
  void tell_leaves(std::size_t individuals, StandMeasures& stand) {
    leaves_.tell(stand.whole);
    if (!are_apart_) return;
    const std::vector<std::uint32_t> trees = trees_of_individuals(individuals, individual_of_tree_);
    of_individual_.resize(individuals);
    for (std::size_t k = 0; k < individuals; ++k) {
      if (trees[k] != kNoTree) of_individual_[k].tell(stand.trees[trees[k]]);
    }
  }

  void tell_thickening(Measures& whole) const {
    if (!(thickening_.length > 0)) return;
    whole.thickened_below = thickening_.min_radius;
    whole.thickened_length = thickening_.thickened / thickening_.length;
    if (thickening_.volume > 0) whole.thickened_volume = thickening_.added / thickening_.volume;
  }

  const Scene& scene_;
  const MeasureOptions& options_;
  const MeshScene* meshes_;
  Progress& progress_;
  TreeList trees_;
  std::size_t stems_ = 0;  // number of stems of earlier blocks
  std::vector<std::uint32_t> individual_of_tree_;
  MaskedSurfaces surfaces_;
  std::optional<BlockLight> light_;  // created after the limits were checked
  std::vector<LitOrgan> lit_;
  Leaves leaves_;
  std::vector<Leaves> of_individual_;
  bool are_apart_ = true;
  BodyThickening thickening_;
};

}  // namespace

void Measures::set_geometry(const GeometryCount& count) {
  triangles = count.triangles;
  instances = count.instances;
  bytes = count.bytes;
}

StandMeasures measure_skeletons(std::span<const Skeleton* const> skeletons, const Scene* scene,
                                const MeasureOptions& options, Progress& progress) {
  std::uint64_t nodes = 0;
  for (const Skeleton* skeleton : skeletons) nodes += skeleton->node_count();
  progress.begin("measuring", nodes);
  TreeList trees;
  trees.add(skeletons, scene, options, progress);
  return trees.finish();
}

std::vector<std::uint32_t> trees_of_organs(const Plant& plant, const SizeLimits& limits, const Progress& progress) {
  std::vector<std::uint32_t> individual_of_tree;
  std::vector<std::uint32_t> individual_of_organ;
  const std::vector<Individual> individuals = expand_in_blocks(plant, limits, progress, [&](const Plant& block) {
    append_individuals_of_trees(block, individual_of_tree);
    for (const Organ& organ : block.organs) individual_of_organ.push_back(organ.individual);
  });
  const std::vector<std::uint32_t> tree = trees_of_individuals(individual_count(individuals), individual_of_tree);
  for (std::uint32_t& number : individual_of_organ) number = number < tree.size() ? tree[number] : kNoTree;
  return individual_of_organ;
}

namespace {

/// Measures a plant, without meshes if `meshes` is null.
StandMeasures measured(const Plant& plant, const SizeLimits& limits, const MeshScene* meshes, const Scene& scene,
                       const MeasureOptions& options, Progress& progress) {
  const PlantTotals totals = totals_of(plant);
  progress.begin(options.organ_light ? "measuring light" : "measuring", totals.nodes + totals.organs);
  PlantMeasurer measurer(scene, options, options.organ_light ? meshes : nullptr, progress);
  const std::vector<Individual> individuals =
      expand_in_blocks(plant, limits, progress, [&](const Plant& block) { measurer.add(block); });
  StandMeasures stand = measurer.finish(individuals);
  if (options.layer_height > 0) stand.layers = measure_leaf_layers(plant, limits, options.layer_height, progress);
  if (meshes != nullptr) stand.whole.set_geometry(count_geometry(*meshes));
  return stand;
}

}  // namespace

StandMeasures measure_plant(const Plant& plant, const SizeLimits& limits, const MeshScene& meshes, const Scene& scene,
                            const MeasureOptions& options, Progress& progress) {
  return measured(plant, limits, &meshes, scene, options, progress);
}

StandMeasures measure_plant(const Plant& plant, const SizeLimits& limits, const Scene& scene,
                            const MeasureOptions& options, Progress& progress) {
  if (options.organ_light) throw std::invalid_argument("the light on organs needs the meshes of the plant");
  return measured(plant, limits, nullptr, scene, options, progress);
}

}  // namespace meristem
