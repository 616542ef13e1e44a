// SPDX-License-Identifier: Apache-2.0
// Self-organizing trees for tests: the sets of parameters that the specification gives figures for, one metre per
// metamer.
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
/// Stands on the edge where branches just open, as the source's trees did.
inline OrganizeParameters slim(int iterations) { return organized(1.8, iterations); }
inline OrganizeParameters full(int iterations) { return organized(2, iterations); }

/// A cut of a shoot by name that leaves a number of its metamers.
inline Operation cut_above(int at, const std::string& shoot, int above) {
  Cut cut;
  cut.above = above;
  Operation operation;
  operation.when = Schedule::at(at);
  operation.shoots = ShootChoice::label(shoot);
  operation.path = "components.tree.operations[0]";
  operation.what = cut;
  return operation;
}

/// One member of a stand.
inline void add_organizer(Stand& stand, const OrganizeParameters& parameters, std::uint64_t seed, const Scene& scene,
                          const Frame& frame = {}, const Limits& limits = {}) {
  stand.add(make_organizer(stand, {{frame, nullptr}}, parameters, RandomKey(seed), scene, limits, "tree"));
}

/// A tree by itself, at the origin if no frame is given.
inline Skeleton grow_organized(const OrganizeParameters& parameters, std::uint64_t seed = 1, const Scene& scene = {},
                               const Frame& frame = {}, const Limits& limits = {}) {
  Stand stand;
  add_organizer(stand, parameters, seed, scene, frame, limits);
  Progress progress;
  stand.grow(progress);
  return std::move(stand.take_skeletons(progress)[0]);
}

/// Metamers of a skeleton with one root, without its seed.
inline double metamer_count(const Skeleton& tree) { return static_cast<double>(tree.node_count()) - 1; }

/// The first number of a column, in the state of the seed.
inline double of_seed(const Skeleton& tree, const char* column) { return tree.extra.find(column)->second[0]; }

}  // namespace meristem
