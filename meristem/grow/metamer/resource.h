// SPDX-License-Identifier: Apache-2.0
// Divides the resource of a tree among its buds. Light is summed from the buds to the root, converted to resource, and
// divided again from the root to the buds. Shoots with more light get more; apical control determines how much more.
//
// Based on: W. Palubicki et al.: Self-organizing tree models for image synthesis (2009), section 4.2 (extended
// Borchert-Honda and priority models); J. Stevens: Automatische generatie van gesnoeide boom modellen, Universiteit
// Hasselt 2023, section 4.2.1 (resource that damaged buds pass back).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/grow/metamer/metamers.h"

namespace meristem {

/// Weights of the priority model by the rank of an axis's buds and laterals. The weight is `highest` for rank 0, the
/// terminal. It falls linearly to `lowest` at the share `reach` of all ranks and then stays constant.
struct PriorityWeights {
  double highest = 1;     ///< weight of the terminal
  double lowest = 0.006;  ///< weight of the last ranks
  double reach = 0.5;     ///< 0 to 1; larger: more laterals get a large share

  /// Returns the weight of `rank` among `count` buds and laterals.
  double operator()(std::size_t rank, std::size_t count) const;
};

/// How a tree's resource is made and divided.
struct ResourceModel {
  /// The rule that divides the resource: at each fork, or along each axis.
  enum class Division { borchert_honda, priority };
  Division division = Division::borchert_honda;  ///< which rule
  double alpha = 2;                              ///< resource per unit of light; larger: all growth is faster
  double alpha0 = 0;                             ///< resource without light
  double lambda = 0.52;          ///< 0 to 1: weight of the terminal side of a fork; larger: more upright trees
  Curve lambda_curve{{{0, 1}}};  ///< factor on `lambda` over the age
  PriorityWeights weights;       ///< weights of the priority model
  int until = 0;                 ///< number of first iterations that use the priority model; 0: all iterations
  int laterals = 0;              ///< buds grow only on axes with at most this number of laterals; 0: on all axes
  /// Share that each lateral takes of the resource that a damaged terminal bud passes down its axis.
  double pass_back = 0.5;
};

/// The light of the buds, by metamer.
struct BudLight {
  std::vector<float> terminal;  ///< light of the terminal bud; for a damaged bud, the light that it would have
  std::vector<float> lateral;   ///< light of the lateral bud

  void resize(std::size_t metamers);  ///< sets the length of both columns; new entries are 0
};

/// Quantities of a tree in one iteration, by metamer.
struct ResourceFlow {
  std::vector<double> light;        ///< light of the open buds at the metamer's tip and beyond
  std::vector<std::uint32_t> buds;  ///< number of open buds at the metamer's tip and beyond
  std::vector<double> resource;     ///< resource that arrives at the metamer from below
  std::vector<double> to_lateral;   ///< share of the resource for the lateral bud or branch
  /// Additional resource of the lateral bud or branch from damaged terminal buds, as a share of `resource`.
  std::vector<double> passed_back;
  double lost = 0;  ///< resource that damaged buds passed back and no lateral took, and resource at forks without light

  /// Returns the resource for the terminal bud or the metamer beyond.
  double terminal(MetamerIndex metamer) const { return resource[metamer] - resource[metamer] * to_lateral[metamer]; }
  /// Returns the resource for the lateral bud or branch.
  double lateral(MetamerIndex metamer) const {
    return resource[metamer] * (to_lateral[metamer] + passed_back[metamer]);
  }
};

/// Sums light and buds toward the root. Cost: linear.
void gather_light(const Metamers& metamers, const BudLight& light, ResourceFlow& flow);

/// Divides the resource of a tree whose light was gathered. `iteration` counts from 1; `age` is the iteration as a
/// share of maturity, 0 to 1. At every metamer, both sides together get the incoming resource plus the resource passed
/// back. Cost: linear, plus one sort for each axis in the priority model.
///
/// `ringed`, by metamer, is the share of the resource made beyond the metamer that a ring below it holds back. This
/// resource is not added at the root, but directly at the metamer. Empty: no rings.
void divide_resource(const Metamers& metamers, const BudLight& light, const ResourceModel& model, int iteration,
                     double age, ResourceFlow& flow, std::span<const float> ringed = {});

}  // namespace meristem
