// SPDX-License-Identifier: Apache-2.0
// The measures of the published evaluation of growth in the light.
#pragma once

#include <cmath>
#include <vector>

#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/measure/crown_light.h"
#include "meristem/measure/tree_form.h"
#include "tests/support/evaluation_trees.h"

namespace meristem {

/// Means over ten clouds. Azimuths are in degrees and averaged on the circle.
struct Evaluation {
  double azimuth = 0;
  double spread = 0;  ///< circular standard deviation of the azimuths
  double altitude = 0;
  double centroid_azimuth = 0;
  double centroid_radius = 0;
  double height = 0;
  double lit_share = 0;  ///< percent
};

/// The measures of one tree.
struct EvaluatedTree {
  DVec3 lean;
  DVec3 centroid;
  double height;
  double lit_share;
};

inline double level(DVec3 vector) { return std::sqrt(vector.x * vector.x + vector.z * vector.z); }

inline EvaluatedTree evaluate_tree(const Scene& scene, const LightResponse& light, std::uint64_t number, double scale) {
  std::vector<Vec3> cloud = evaluation_cloud(number);
  for (Vec3& point : cloud) point *= static_cast<float>(scale);
  const Skeleton skeleton = grow_evaluation_tree(cloud, scene, light);
  const TreeForm form = measure_form(skeleton, NodeChildren(skeleton));
  return {.lean = form.segment_sum,
          .centroid = form.node_sum / static_cast<double>(form.nodes),
          .height = form.height,
          .lit_share = 100 * measure_crown_light(form.crown_hull, scene).lit_share};
}

/// `scale` is the scale of the cloud before growth.
inline Evaluation evaluate(const Scene& scene, const LightResponse& light, double scale = 1) {
  constexpr std::size_t kClouds = 10;
  std::vector<EvaluatedTree> trees(kClouds);
  parallel_for(kClouds, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) trees[k] = evaluate_tree(scene, light, k, scale);
  });
  Evaluation mean;
  DVec3 leans(0);
  DVec3 centroids(0);
  for (const EvaluatedTree& tree : trees) {
    leans += DVec3(tree.lean.x, 0, tree.lean.z) / level(tree.lean);
    centroids += tree.centroid;
    mean.altitude += degrees(math::atan2(tree.lean.y, level(tree.lean))) / kClouds;
    mean.centroid_radius += level(tree.centroid) / kClouds;
    mean.height += tree.height / kClouds;
    mean.lit_share += tree.lit_share / kClouds;
  }
  mean.azimuth = degrees(sky_direction(Vec3(leans)).azimuth);
  mean.spread = degrees(std::sqrt(-2 * math::log(level(leans) / kClouds)));
  mean.centroid_azimuth = degrees(sky_direction(Vec3(centroids)).azimuth);
  return mean;
}

/// Returns the evaluation of trees with a mean height of `height` metres, by scaling their clouds before growth.
inline Evaluation evaluate_at_height(const Scene& scene, const LightResponse& light, double height) {
  double scale = 1;
  Evaluation mean;
  for (int k = 0; k < 3; ++k) {
    mean = evaluate(scene, light, scale);
    scale *= height / mean.height;
  }
  return mean;
}

}  // namespace meristem
