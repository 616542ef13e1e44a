// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/plant/skeleton.h"

namespace meristem {

struct PipeModel {
  double tip_radius = 0.004;  ///< metres; raised, all wood gets thicker in proportion
  double exponent = 2.4;      ///< raised, trunks get thinner; 2 keeps the cross-section's area, 3 its cube
  double memory = 1;          ///< 0 to 1: how far wood keeps the share of branches it has shed; raised, thicker
};

/// Sets all radii by the pipe model: at a fork the parent's radius to the power of the exponent is the sum of its
/// children's; tips have the tip radius. Tips that the column `shed` counts are borne as far as memory goes. Throws
/// std::invalid_argument unless tip radius and exponent are above 0.
/// (Murray's rule with exponent 3, da Vinci's with 2.)
void assign_pipe_radii(Skeleton& skeleton, const PipeModel& model);

/// Sets `axis` and `order` from radii: the child with the largest radius continues its parent's axis (tie: the lower
/// index), every other child starts a lateral axis of the next order.
void assign_axes(Skeleton& skeleton);

}  // namespace meristem
