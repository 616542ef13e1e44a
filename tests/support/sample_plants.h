// SPDX-License-Identifier: Apache-2.0
// Small plants for tests of writers.
#pragma once

#include <utility>

#include "meristem/base/random.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Two stems: a fork of four nodes with a column `light` as "tree", and a rod of three nodes as instance 3 of "vine".
inline Plant two_stems() {
  Stem tree{.parts = {{.component = "tree"}}};
  Skeleton& fork = tree.skeleton;
  fork.add_node(kNoNode, {0, 0, 0}, 0);
  fork.add_node(0, {0, 1, 0}, 1);
  fork.add_node(1, {0, 2, 0}, 2);
  fork.add_node(1, {0.5F, 1.5F, 0}, 2);
  fork.radius = {0.1F, 0.09F, 0.05F, 0.04F};
  fork.axis = {0, 0, 0, 1};
  fork.order = {0, 0, 0, 1};
  fork.extra["light"] = {0, 0.1F, 0.2F, 0.3F};

  Stem vine{.parts = {{.component = "vine", .instance = 3}}};
  Skeleton& rod = vine.skeleton;
  rod.add_node(kNoNode, {3, 0, 0}, 0);
  rod.add_node(0, {3, 0.1F, 0}, 1);
  rod.add_node(1, {3, 1.0F / 3, 0}, 2.5F);
  rod.radius = {0.01F, 0.01F, 1e-7F};

  Plant plant;
  plant.stems.push_back(std::move(tree));
  plant.stems.push_back(std::move(vine));
  return plant;
}

/// One stem without forks, with `nodes` nodes at random positions.
inline Plant long_stem(std::size_t nodes) {
  const RandomKey key(9);
  Stem stem{.parts = {{.component = "stem"}}};
  for (NodeIndex k = 0; k < nodes; ++k) stem.skeleton.add_node(k == 0 ? kNoNode : k - 1, key.direction(k), k * 0.1F);
  Plant plant;
  plant.stems.push_back(std::move(stem));
  return plant;
}

}  // namespace meristem
