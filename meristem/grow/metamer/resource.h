// SPDX-License-Identifier: Apache-2.0
// How a tree divides what its buds earn: light is summed from the buds to the root, turned into resource there, and
// divided again on the way back, so that shoots with more light get more and apical control decides how much more.
//
// Based on: W. Palubicki et al.: Self-organizing tree models for image synthesis (2009), section 4.2 (extended
// Borchert-Honda and priority models); J. Stevens: Automatische generatie van gesnoeide boom modellen, Universiteit
// Hasselt 2023, section 4.2.1 (what damaged buds pass back).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/base/curve.h"
#include "meristem/grow/metamer/metamers.h"

namespace meristem {

/// Weights over the rank of an axis's buds and laterals, for the priority model: from `highest` at the first, which is
/// the terminal, straight down to `lowest` at `reach` of all, and so on to the last.
struct PriorityWeights {
  double highest = 1;
  double lowest = 0.006;
  double reach = 0.5;  ///< 0 to 1; raised, more laterals have a good share

  double operator()(std::size_t rank, std::size_t count) const;
};

struct ResourceModel {
  enum class Division { borchert_honda, priority };
  Division division = Division::borchert_honda;
  double alpha = 2;      ///< resource for each unit of light; raised, all grows faster
  double alpha0 = 0;     ///< resource that comes without light
  double lambda = 0.52;  ///< 0 to 1: what the terminal side of a fork has before the lateral; raised, more upright
  Curve lambda_curve{{{0, 1}}};  ///< factor on it over the age
  PriorityWeights weights;
  int until = 0;           ///< the priority model holds in this number of first iterations; 0: in all
  int laterals = 0;        ///< buds grow only on axes with at most this number of laterals; 0: on all
  double pass_back = 0.5;  ///< share that each lateral takes of what a damaged terminal bud passes back down its axis
};

/// The light of the buds, by metamer.
struct BudLight {
  std::vector<float> terminal;  ///< light of the terminal bud; for a damaged bud, the light that it would have
  std::vector<float> lateral;

  void resize(std::size_t metamers);
};

/// What all metamers of a tree have in one iteration, by metamer.
struct ResourceFlow {
  std::vector<double> light;        ///< light of the open buds at the metamer's tip and beyond
  std::vector<std::uint32_t> buds;  ///< open buds at the metamer's tip and beyond
  std::vector<double> resource;     ///< resource that comes to the metamer from below
  std::vector<double> to_lateral;   ///< share of the resource that the metamer's lateral bud or branch gets
  std::vector<double>
      passed_back;  ///< what the lateral bud or branch gets besides from above, as a share of `resource`
  double lost = 0;  ///< what damaged buds passed back and nobody took, and what came to forks without light

  double terminal(MetamerIndex metamer) const { return resource[metamer] - resource[metamer] * to_lateral[metamer]; }
  double lateral(MetamerIndex metamer) const {
    return resource[metamer] * (to_lateral[metamer] + passed_back[metamer]);
  }
};

/// Sums light and buds toward the root. Cost is linear.
void gather_light(const Metamers& metamers, const BudLight& light, ResourceFlow& flow);

/// Divides the resource of a tree whose light was gathered. `iteration` counts from 1; `age` is its share of maturity,
/// 0 to 1. At every metamer what its two sides get is what came, with what was passed back; cost is linear, with a sort
/// for each axis in the priority model.
///
/// `ringed`, by metamer, is the share of what leaves make from there on that a ring in the bark below the metamer keeps
/// from going down: it is not counted at the root, but comes to the metamer besides what comes from below. Empty: there
/// are no rings.
void divide_resource(const Metamers& metamers, const BudLight& light, const ResourceModel& model, int iteration,
                     double age, ResourceFlow& flow, std::span<const float> ringed = {});

}  // namespace meristem
