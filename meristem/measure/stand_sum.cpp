// SPDX-License-Identifier: Apache-2.0
// Measures trees one by one and combines them into the measures of a stand. Counts, lengths and areas are added. Sizes
// come from the tallest tree, and angles, ratios and exponents are pooled over all trees.
#include "meristem/measure/stand_sum.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meristem/base/math.h"
#include "meristem/measure/crown_light.h"
#include "meristem/measure/strahler.h"
#include "meristem/plant/split_trees.h"

namespace meristem {
namespace {

TreeRecord record_tree(const Skeleton& skeleton, const Scene* scene, const MeasureOptions& options,
                       const Progress& progress) {
  const NodeChildren children(skeleton);
  TreeRecord record;
  if (skeleton.node_count() > 0) record.position = skeleton.position[0];
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

/// Returns the azimuth from north over east in [0, 2 pi). Returns nothing for a vertical vector.
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

bool has_one_root(const Skeleton& skeleton) {
  return std::count(skeleton.parent.begin(), skeleton.parent.end(), kNoNode) == 1;
}

}  // namespace

std::vector<TreeRecord> record_trees(const Skeleton& skeleton, const Scene* scene, const MeasureOptions& options,
                                     const Progress& progress) {
  std::vector<TreeRecord> records;
  if (has_one_root(skeleton)) {
    records.push_back(record_tree(skeleton, scene, options, progress));
    return records;
  }
  for (const Skeleton& tree : split_trees(skeleton)) records.push_back(record_tree(tree, scene, options, progress));
  return records;
}

void StandSum::add(const TreeRecord& tree) {
  add_sums(tree.form, sums_);
  add_columns(sums_.strahler_streams, tree.streams);
  segment_sum_ += tree.form.segment_sum;
  node_sum_ += tree.form.node_sum;
  forks_.append(tree.forks);
  if (!tallest_ || tree.form.height > tallest_->height) tallest_ = tree.form;
  if (!tree.lit_share) return;
  hull_area_ += tree.form.crown_hull_area;
  lit_area_ += tree.form.crown_hull_area * *tree.lit_share;
}

Measures StandSum::finish() {
  Measures measures = std::move(sums_);
  if (!tallest_) return measures;
  measures.axes = std::accumulate(measures.axes_by_order.begin(), measures.axes_by_order.end(), std::uint64_t{0});
  measures.length = std::accumulate(measures.length_by_order.begin(), measures.length_by_order.end(), 0.0);
  copy_size(*tallest_, measures);
  if (hull_area_ > 0) measures.lit_share = lit_area_ / hull_area_;
  set_directions(segment_sum_, node_sum_ / static_cast<double>(std::max<std::uint64_t>(measures.nodes, 1)), measures);
  measures.bifurcation_ratios = bifurcation_ratios(measures.strahler_streams);
  if (measures.strahler_streams.size() > 1) {
    measures.bifurcation_ratio = mean_bifurcation_ratio(measures.strahler_streams);
  }
  measures.branching_angle = distribution(std::move(forks_.branching_angles));
  measures.pipe_exponent = distribution(std::move(forks_.pipe_exponents));
  measures.pipe_unsolved = forks_.pipe_unsolved;
  measures.area_ratio = distribution(std::move(forks_.area_ratios));
  return measures;
}

}  // namespace meristem
