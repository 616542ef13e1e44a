// SPDX-License-Identifier: Apache-2.0
// Space colonization: a skeleton grows into a cloud of attraction points. In each step, every living point pulls its
// nearest node. A pulled node gets a child in the mean direction of its points. Points near the tree are used up.
//
// Based on: A. Runions, B. Lane, P. Prusinkiewicz: Modeling trees with a space colonization algorithm (2007), and J.
// Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund 2020, ch. 3.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/random.h"
#include "meristem/grow/colonize/light_response.h"
#include "meristem/grow/stand.h"
#include "meristem/plant/finish.h"
#include "meristem/plant/pipe_radii.h"
#include "meristem/scene/scene.h"

namespace meristem {

/// Parameters of space colonization, for one plant.
struct ColonizeParameters {
  double step = 0.05;      ///< metres between nodes; smaller: finer and slower
  double influence = 0.6;  ///< metres within which a point pulls, may be infinite; larger: smoother, sparser branches
  double kill = 0.3;       ///< metres within which a node uses up its points; smaller: denser twigs
  int iterations = 1000;   ///< largest number of steps
  Vec3 bias{0};            ///< added to each growth direction; (0, 0.2, 0) bends all growth upward a little
  Directions directions;   ///< only fields added to the scene's light and gravity act on growth and on `light.field`
  LightResponse light;     ///< response to the light of the scene and to shade
  FinishOptions finish;    ///< post-processing of the finished skeleton
  PipeModel radii;         ///< radii of the finished skeleton
  TraceRequest request;    ///< parts to record: steps and points
};

/// The begin of one tree and the points that it brings into the stand (world space).
struct Seedling {
  Vec3 root{0};              ///< metres
  std::vector<Vec3> points;  ///< attraction points, metres
};

/// Makes colonizing trees in a stand. Together they are one member of the stand and one skeleton, and they share their
/// points with all other trees of the stand. `key` breaks ties; `component` is the id in error messages. A root beyond
/// the influence of all points grows a straight stem toward the nearest point until points pull it. The nearest point
/// is one of its own, or any of the stand if it brought none. Without points, the plant consists of its roots.
///
/// Throws InputError if the stand's points exceed the limits, if a root is inside an obstacle, or if obstacles leave no
/// points. Throws std::invalid_argument unless step, influence and kill distance are above 0 and iterations at least 0.
/// Throws Cancelled. During growth, throws InputError if the stand's nodes exceed the limits. Throws
/// std::invalid_argument for points that are not finite.
///
/// No node is inside an obstacle of the scene, and no segment passes through one. Points inside obstacles are removed.
/// `scene` must outlive the growth and must be the same for all plants of a stand.
std::unique_ptr<Grower> make_colonizer(Stand& stand, std::vector<Seedling> seedlings,
                                       const ColonizeParameters& parameters, RandomKey key, const Scene& scene,
                                       const SizeLimits& limits, std::string component, const Progress& progress);

}  // namespace meristem
