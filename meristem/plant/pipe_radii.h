// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Parameters of the pipe model: the thickness of wood by the number of tips that it bears. All growth models use it.
struct PipeModel {
  double tip_radius = 0.004;  ///< radius of tips, metres; all radii are proportional to it
  double exponent = 2.4;      ///< larger: thinner trunks; at forks, 2 preserves the sum of r^2 (area), 3 the sum of r^3
  double memory = 1;          ///< 0 to 1: share of the tips of shed branches that still count; larger: thicker wood
};

/// Returns the number of tips at or beyond each node of a forest, given the parent of each node. `lost` is the number
/// of tips lost at each node, or empty; each lost tip counts `memory`. A node without children counts one tip, or its
/// remembered lost tips if they are more.
std::vector<double> count_tips(std::span<const NodeIndex> parent, std::span<const float> lost, double memory = 1);

/// Returns the radius of each node of a forest in metres, by the pipe model. `parent` and `lost` are as in
/// count_tips(). Throws std::invalid_argument unless tip radius and exponent are above 0.
std::vector<float> pipe_radii(std::span<const NodeIndex> parent, std::span<const float> lost, const PipeModel& model);

/// Sets all radii by the pipe model: at a fork, the parent's radius to the power of the exponent is the sum over the
/// children; tips have the tip radius. Exponent 3 is Murray's rule, 2 is da Vinci's. Tips counted in the column `shed`
/// contribute by the model's memory. Throws std::invalid_argument unless tip radius and exponent are above 0.
void assign_pipe_radii(Skeleton& skeleton, const PipeModel& model);

/// Sets `axis` and `order` from the radii. The child with the largest radius continues its parent's axis (tie: the
/// lower index). Every other child starts a lateral axis of the next order.
void assign_axes(Skeleton& skeleton);

}  // namespace meristem
