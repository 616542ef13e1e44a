// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/measure/forks.h"
#include "meristem/measure/strahler.h"
#include "meristem/measure/tree_form.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/plant/split_trees.h"
#include "meristem/shape/body_meshes.h"

namespace meristem {
namespace {

/// What is kept of a tree until stands are summed up.
struct TreeRecord {
  TreeForm form;
  ForkSamples forks;
  std::vector<std::uint64_t> streams;
  std::optional<double> lit_share;
  TreeOrigin origin;
};

TreeRecord record_tree(const Skeleton& skeleton, const Scene* scene, const MeasureOptions& options,
                       const Progress& progress) {
  const Children children(skeleton);
  TreeRecord record;
  if (skeleton.node_count() > 0) record.origin.position = skeleton.position[0];
  record.form = measure_form(skeleton, children, &progress);
  if (scene != nullptr && !record.form.crown_hull.triangles.empty()) {
    record.lit_share = measure_crown_light(record.form.crown_hull, *scene, options.crown_rays, &progress).lit_share;
  }
  record.form.crown_hull = {};
  progress.check();
  record.forks = sample_forks(skeleton, children, options.fork_diameter);
  progress.check();
  record.streams = strahler_streams(skeleton, strahler_numbers(skeleton, children));
  return record;
}

template <class T>
void add_columns(std::vector<T>& to, const std::vector<T>& from) {
  if (to.size() < from.size()) to.resize(from.size(), T{0});
  for (std::size_t k = 0; k < from.size(); ++k) to[k] += from[k];
}

/// From north over east, in [0, 2 pi); none for a vertical vector.
std::optional<double> azimuth_of(DVec3 vector) {
  if (vector.x == 0 && vector.z == 0) return {};
  const double azimuth = math::atan2(vector.x, -vector.z);
  return azimuth < 0 ? azimuth + 2 * kPi : azimuth;
}

double horizontal(DVec3 vector) { return glm::length(glm::dvec2(vector.x, vector.z)); }

void add_sums(const TreeForm& form, Measures& sums) {
  ++sums.trees;
  sums.nodes += form.nodes;
  sums.metamers += form.metamers;
  sums.tips += form.tips;
  sums.forks += form.forks;
  sums.crown_ground_area += form.crown_ground_area;
  sums.crown_hull_area += form.crown_hull_area;
  sums.crown_hull_volume += form.crown_hull_volume;
  sums.stem_count += form.stems;
  sums.basal_area += kPi / 4 * form.diameter_squares;
  add_columns(sums.axes_by_order, form.axes_by_order);
  add_columns(sums.length_by_order, form.length_by_order);
}

void copy_size(const TreeForm& tallest, Measures& measures) {
  measures.height = tallest.height;
  measures.crown_height = tallest.crown_height;
  measures.crown_width = tallest.crown_width;
  measures.crown_mean_width = tallest.crown_mean_width;
  if (tallest.base_diameter > 0) measures.base_diameter = tallest.base_diameter;
  measures.stem_diameter = tallest.diameter;
  if (tallest.stems > 0) measures.stem_equivalent_diameter = std::sqrt(tallest.diameter_squares);
  if (tallest.diameter) measures.slenderness = tallest.height / *tallest.diameter;
}

void set_directions(DVec3 segment_sum, DVec3 centroid, Measures& measures) {
  measures.inclination_azimuth = azimuth_of(segment_sum);
  if (glm::length(segment_sum) > 0) {
    measures.inclination_altitude = math::atan2(segment_sum.y, horizontal(segment_sum));
  }
  measures.centroid_azimuth = azimuth_of(centroid);
  measures.centroid_radius = horizontal(centroid);
}

/// The lit share of all hulls together.
std::optional<double> mean_lit_share(std::span<const TreeRecord> records) {
  double area = 0;
  double lit = 0;
  for (const TreeRecord& record : records) {
    if (!record.lit_share) continue;
    area += record.form.crown_hull_area;
    lit += record.form.crown_hull_area * *record.lit_share;
  }
  return area > 0 ? std::optional(lit / area) : std::nullopt;
}

/// The measures of a stand; of one tree, if there is one.
Measures summarise(std::span<const TreeRecord> records) {
  Measures measures;
  if (records.empty()) return measures;
  const TreeRecord* tallest = &records.front();
  DVec3 segment_sum(0);
  DVec3 node_sum(0);
  ForkSamples samples;
  for (const TreeRecord& record : records) {
    add_sums(record.form, measures);
    add_columns(measures.strahler_streams, record.streams);
    segment_sum += record.form.segment_sum;
    node_sum += record.form.node_sum;
    samples.append(record.forks);
    if (record.form.height > tallest->form.height) tallest = &record;
  }
  measures.axes = std::accumulate(measures.axes_by_order.begin(), measures.axes_by_order.end(), std::uint64_t{0});
  measures.length = std::accumulate(measures.length_by_order.begin(), measures.length_by_order.end(), 0.0);
  copy_size(tallest->form, measures);
  measures.lit_share = mean_lit_share(records);
  set_directions(segment_sum, node_sum / static_cast<double>(std::max<std::uint64_t>(measures.nodes, 1)), measures);
  measures.bifurcation_ratios = bifurcation_ratios(measures.strahler_streams);
  if (measures.strahler_streams.size() > 1) {
    measures.bifurcation_ratio = mean_bifurcation_ratio(measures.strahler_streams);
  }
  measures.branching_angle = distribution(std::move(samples.branching_angles));
  measures.pipe_exponent = distribution(std::move(samples.pipe_exponents));
  measures.pipe_unsolved = samples.pipe_unsolved;
  measures.area_ratio = distribution(std::move(samples.area_ratios));
  return measures;
}

bool has_one_root(const Skeleton& skeleton) {
  return std::count(skeleton.parent.begin(), skeleton.parent.end(), kNoNode) == 1;
}

/// The individual of each tree: of each root of each stem.
std::vector<std::uint32_t> individuals_of_trees(const Plant& plant) {
  std::vector<std::uint32_t> individuals;
  for (const Stem& stem : plant.stems) {
    const auto& parents = stem.skeleton.parent;
    const auto roots = static_cast<std::size_t>(std::count(parents.begin(), parents.end(), kNoNode));
    for (std::size_t root = 0; root < roots; ++root) {
      individuals.push_back(root < stem.individual_of_root.size() ? stem.individual_of_root[root] : 0);
    }
  }
  return individuals;
}

/// The tree of each individual, which is kNoTree where it has none or several.
std::vector<std::uint32_t> trees_of_individuals(const Plant& plant, const std::vector<std::uint32_t>& of_trees) {
  const std::size_t count = std::max<std::size_t>(plant.individuals.size(), 1);
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

/// Leaves, and the light on them if it is known.
struct Leaves {
  Foliage foliage;
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

/// Measures the leaves of all trees together, and of each tree unless leaves belong to several trees.
void measure_leaves(const Plant& plant, const Limits& limits, StandMeasures& stand, Progress& progress) {
  const std::vector<OrganArea> areas = organ_areas(plant, progress);
  const std::vector<std::uint32_t> tree_of_organ = trees_of_organs(plant, limits, progress);
  Leaves whole;
  std::vector<Leaves> of_tree(stand.trees.size());
  bool are_apart = true;
  for (std::size_t k = 0; k < areas.size(); ++k) {
    if (!is_leaf(plant, plant.prototypes[plant.organs[k].prototype])) continue;
    const auto add_to = [&](Leaves& leaves) {
      leaves.foliage.add(areas[k]);
      if (!stand.organs.empty()) leaves.light.add(stand.organs[k]);
    };
    add_to(whole);
    if (tree_of_organ[k] != kNoTree) add_to(of_tree[tree_of_organ[k]]);
    are_apart = are_apart && plant.organs[k].individual != kNoIndividual;
  }
  whole.tell(stand.whole);
  if (!are_apart) return;
  for (const std::uint32_t tree : trees_of_individuals(plant, individuals_of_trees(plant))) {
    if (tree != kNoTree) of_tree[tree].tell(stand.trees[tree]);
  }
}

}  // namespace

StandMeasures measure_skeletons(std::span<const Skeleton* const> skeletons, const Scene* scene,
                                const MeasureOptions& options, Progress& progress) {
  std::uint64_t nodes = 0;
  for (const Skeleton* skeleton : skeletons) nodes += skeleton->node_count();
  progress.begin("measuring", nodes);
  std::vector<std::vector<TreeRecord>> of_skeleton(skeletons.size());
  parallel_for(skeletons.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (has_one_root(*skeletons[k])) {
        of_skeleton[k].push_back(record_tree(*skeletons[k], scene, options, progress));
        progress.advance(skeletons[k]->node_count());
        continue;
      }
      for (const Skeleton& tree : split_trees(*skeletons[k])) {
        of_skeleton[k].push_back(record_tree(tree, scene, options, progress));
        progress.advance(tree.node_count());
      }
    }
  });
  std::vector<TreeRecord> records;
  for (std::size_t k = 0; k < skeletons.size(); ++k) {
    for (TreeRecord& record : of_skeleton[k]) {
      record.origin.skeleton = k;
      records.push_back(std::move(record));
    }
  }
  StandMeasures stand;
  stand.whole = summarise(records);
  for (const TreeRecord& record : records) {
    stand.trees.push_back(summarise(std::span(&record, 1)));
    stand.origins.push_back(record.origin);
  }
  return stand;
}

std::vector<std::uint32_t> trees_of_organs(const Plant& grown, const Limits& limits, const Progress& progress) {
  const ExpandedPlant plant(grown, limits, progress);
  const std::vector<std::uint32_t> tree = trees_of_individuals(*plant, individuals_of_trees(*plant));
  std::vector<std::uint32_t> trees;
  trees.reserve(plant->organs.size());
  for (const Organ& organ : plant->organs) {
    trees.push_back(organ.individual < tree.size() ? tree[organ.individual] : kNoTree);
  }
  return trees;
}

namespace {

void count_geometry(const MeshScene& meshes, Measures& whole) {
  whole.triangles = meshes.triangle_count();
  whole.instances = meshes.instance_count();
  std::uint64_t bytes = 0;
  for (const MeshInstances& mesh : meshes.meshes)
    bytes +=
        mesh.mesh->bytes() + (mesh.frames.size() + (mesh.places == nullptr ? 0 : mesh.places->size())) * sizeof(Frame);
  whole.bytes = bytes;
}

/// Measures a plant, without meshes if `meshes` is null.
StandMeasures measured(const Plant& grown, const Limits& limits, const MeshScene* meshes, const Scene& scene,
                       const MeasureOptions& options, Progress& progress) {
  const ExpandedPlant expanded(grown, limits, progress);
  const Plant& plant = *expanded;
  std::vector<const Skeleton*> skeletons;
  for (const Stem& stem : plant.stems) skeletons.push_back(&stem.skeleton);
  StandMeasures stand = measure_skeletons(skeletons, &scene, options, progress);
  const std::vector<std::uint32_t> individuals = individuals_of_trees(plant);
  for (std::size_t k = 0; k < stand.origins.size(); ++k) {
    TreeOrigin& origin = stand.origins[k];
    const StemPart& root = plant.stems[origin.skeleton].parts.front();
    origin.component = root.component;
    origin.instance = root.instance;
    if (individuals[k] < plant.individuals.size()) origin.row = plant.individuals[individuals[k]].row;
  }
  if (options.organ_light) stand.organs = measure_organ_light(plant, limits, *meshes, scene, progress);
  measure_leaves(plant, limits, stand, progress);
  Measures& whole = stand.whole;
  if (options.layer_height > 0) stand.layers = measure_leaf_layers(plant, limits, options.layer_height, progress);
  const Thickening thickening = find_thickening(plant);
  if (thickening.length > 0) {
    whole.thickened_below = thickening.least_radius;
    whole.thickened_length = thickening.thickened / thickening.length;
    if (thickening.volume > 0) whole.thickened_volume = thickening.added / thickening.volume;
  }
  if (meshes != nullptr) count_geometry(*meshes, whole);
  return stand;
}

}  // namespace

StandMeasures measure_plant(const Plant& plant, const Limits& limits, const MeshScene& meshes, const Scene& scene,
                            const MeasureOptions& options, Progress& progress) {
  return measured(plant, limits, &meshes, scene, options, progress);
}

StandMeasures measure_plant(const Plant& plant, const Limits& limits, const Scene& scene, const MeasureOptions& options,
                            Progress& progress) {
  if (options.organ_light) throw std::invalid_argument("the light on organs needs the meshes of the plant");
  return measured(plant, limits, nullptr, scene, options, progress);
}

}  // namespace meristem
