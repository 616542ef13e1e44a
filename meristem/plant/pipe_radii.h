// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// How thick wood is for the tips that it bears, in all models of growth.
struct PipeModel {
  double tip_radius = 0.004;  ///< metres; raised, all wood gets thicker in proportion
  double exponent = 2.4;      ///< raised, trunks get thinner; 2 keeps the cross-section's area, 3 its cube
  double memory = 1;          ///< 0 to 1: how far wood keeps the share of branches it has shed; raised, thicker
};

/// The tips at or beyond each node of a forest, by its parents. `lost` says how many are lost at each node, or is
/// empty; wood remembers `memory` of them. A node that bears nothing counts one tip, or all it remembers.
std::vector<double> count_tips(std::span<const NodeIndex> parent, std::span<const float> lost, double memory = 1);

/// The radius at each node of a forest by the pipe model, from its parents and lost tips as in count_tips(). Throws
/// std::invalid_argument unless tip radius and exponent are above 0.
std::vector<float> pipe_radii(std::span<const NodeIndex> parent, std::span<const float> lost, const PipeModel& model);

/// Sets all radii by the pipe model: at a fork the parent's radius to the power of the exponent is the sum of its
/// children's; tips have the tip radius. Tips that the column `shed` counts are borne as far as memory goes. Throws
/// std::invalid_argument unless tip radius and exponent are above 0.
/// (Murray's rule with exponent 3, da Vinci's with 2.)
void assign_pipe_radii(Skeleton& skeleton, const PipeModel& model);

/// Sets `axis` and `order` from radii: the child with the largest radius continues its parent's axis (tie: the lower
/// index), every other child starts a lateral axis of the next order.
void assign_axes(Skeleton& skeleton);

}  // namespace meristem
