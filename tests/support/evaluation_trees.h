// SPDX-License-Identifier: Apache-2.0
// The trees and scenes of a published evaluation of growth in the light.
//
// Based on: J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund
// 2020, chapter 5.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "meristem/base/vec.h"
#include "meristem/grow/colonize/colonize.h"
#include "meristem/scene/crown/crown_points.h"
#include "meristem/scene/crown/profile_crown.h"

namespace meristem {

/// Returns attraction points uniform in the crown. Each number gives another cloud.
inline std::vector<Vec3> evaluation_cloud(std::uint64_t number, std::uint64_t count = 900) {
  const ProfileCrown crown({{0, 0.4F}, {0.96F, 1.42F}, {1.6F, 2.61F}, {0, 3.8F}});
  Progress progress;
  return sample_crown(crown, count, RandomKey(number), progress);
}

/// Grows a tree from the origin into a cloud, without post-processing.
inline Skeleton grow_evaluation_tree(const std::vector<Vec3>& cloud, const Scene& scene, const LightResponse& light) {
  const ColonizeParameters parameters{.step = 0.02,
                                      .influence = std::numeric_limits<double>::infinity(),
                                      .kill = 0.08,
                                      .light = light,
                                      .finish = {.decimate = 0, .relax = false, .subdivide = 0}};
  Progress progress;
  Stand stand;
  stand.add(
      make_colonizer(stand, {{Vec3(0), cloud}}, parameters, RandomKey(1), scene, SizeLimits(), "tree", Progress()));
  stand.grow(progress);
  return std::move(stand.take_skeletons(progress)[0]);
}

/// Scene A: the sun in the south, without obstacles.
inline Scene evaluation_scene_a() {
  Scene scene;
  scene.light.sun = {{unit_vector({radians(180), radians(61)}), 1}};
  return scene;
}

/// Scene B: a building in the south, and the sun of a day in May.
inline Scene evaluation_scene_b() {
  Scene scene;
  Obstacle building;
  building.mesh = box_mesh({-3, 0, 3}, {3, 8, 6});
  scene.obstacles = Obstacles({building});
  scene.light.sun = sun_of_day(radians(51.51494), 126, 1);
  return scene;
}

}  // namespace meristem
