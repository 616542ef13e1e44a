// SPDX-License-Identifier: Apache-2.0
// Space colonization: a skeleton grows into a cloud of attraction points. Each step every living point pulls its
// nearest node, nodes that are pulled get a child toward the mean direction, and points that a node has come near to
// are used up.
//
// Based on: A. Runions, B. Lane, P. Prusinkiewicz: Modeling trees with a space colonization algorithm (2007), and
// J. Jansen, Space Colonization-gestützte Generierung realitätskonformer Vegetationsszenarien, TU Dortmund 2020, ch. 3.
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

struct ColonizeParameters {
  double step = 0.05;      ///< metres between nodes; smaller: finer and slower
  double influence = 0.6;  ///< metres within which a point pulls, may be infinite; larger: smoother, sparser branches
  double kill = 0.3;       ///< metres within which a node uses up a point that it pulls; smaller: denser twigs
  int iterations = 1000;   ///< largest number of steps
  Vec3 bias{0};            ///< added to each growth direction: (0, 0.2, 0) makes all grow upward a little
  Directions directions;   ///< whose given light and gravity are added, too; the scene's own are not felt
  LightResponse light;
  Finish finish;
  PipeModel radii;
  TraceWish wish;  ///< steps and points are recorded where they are asked for
};

/// Where one tree begins, and the points that it brings into the stand (world space).
struct Seedling {
  Vec3 root{0};
  std::vector<Vec3> points;
};

/// Colonizing trees in a stand, whose points they share with all others there; together one member of the stand and one
/// skeleton. `key` breaks ties; `component` is the id that errors name. A root out of reach of all points sends a
/// straight stem toward the nearest of its own, or of the stand's where it brought none, until points pull it. Without
/// any, the plant is its roots alone.
///
/// Growth throws InputError where the crown is out of reach of the iterations, or where the stand's nodes exceed the
/// limits; std::invalid_argument for points that are not finite. make_colonizer itself throws InputError where the
/// stand's points exceed the limits, and std::invalid_argument unless step, influence and kill distance are above 0 and
/// iterations at least 0.
///
/// No node stands in one of the scene's obstacles and no segment passes through one; points inside them are left out.
/// make_colonizer throws InputError where a root stands in one, or where they leave no points, and Cancelled. `scene`
/// must outlive the growth; it is the same for all plants of a stand.
std::unique_ptr<Grower> make_colonizer(Stand& stand, std::vector<Seedling> seedlings,
                                       const ColonizeParameters& parameters, RandomKey key, const Scene& scene,
                                       const Limits& limits, std::string component, const Progress& progress);

}  // namespace meristem
