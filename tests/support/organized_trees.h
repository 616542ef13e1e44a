// SPDX-License-Identifier: Apache-2.0
// Self-organizing trees for tests, with the parameters for which the specification gives figures. A metamer has a
// length of one metre.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "meristem/grow/organize/organize.h"

namespace meristem {

inline OrganizeParameters organized(double alpha, int iterations) {
  OrganizeParameters parameters;
  parameters.iterations = iterations;
  parameters.length = 1;
  parameters.resource.alpha = alpha;
  return parameters;
}
/// At the critical value where branches just open, like the trees of the source.
inline OrganizeParameters slim(int iterations) { return organized(1.8, iterations); }
inline OrganizeParameters full(int iterations) { return organized(2, iterations); }

/// Returns a cut of a named shoot that keeps `above` of its metamers.
inline TreeOperation cut_above(int at, const std::string& shoot, int above) {
  CutOperation cut;
  cut.above = above;
  TreeOperation operation;
  operation.when = OperationSchedule::at(at);
  operation.shoots = ShootChoice::label(shoot);
  operation.path = "components.tree.operations[0]";
  operation.what = cut;
  return operation;
}

/// Adds one tree to a stand.
inline void add_organizer(Stand& stand, const OrganizeParameters& parameters, std::uint64_t seed, const Scene& scene,
                          const Frame& frame = {}, const SizeLimits& limits = {}) {
  stand.add(make_organizer(stand, {{frame, nullptr}}, parameters, RandomKey(seed), scene, limits, "tree"));
}

/// Grows a single tree, at the origin if no frame is given.
inline Skeleton grow_organized(const OrganizeParameters& parameters, std::uint64_t seed = 1, const Scene& scene = {},
                               const Frame& frame = {}, const SizeLimits& limits = {}) {
  Stand stand;
  add_organizer(stand, parameters, seed, scene, frame, limits);
  Progress progress;
  stand.grow(progress);
  return std::move(stand.take_skeletons(progress)[0]);
}

/// Returns the number of metamers of a skeleton with one root, without its seed.
inline double metamer_count(const Skeleton& tree) { return static_cast<double>(tree.node_count()) - 1; }

/// Returns the first number of a column: the value of the seed.
inline double of_seed(const Skeleton& tree, const char* column) { return tree.extra.find(column)->second[0]; }

}  // namespace meristem
