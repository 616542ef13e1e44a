// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/scene/light/light.h"

namespace meristem {

/// Times of a day at which the sun is sampled, in hours of true solar time.
struct DaySamples {
  double every = 1;    ///< hours from one time to the next, above 0
  double anchor = 12;  ///< one of the times, 0 to 24; the others are whole multiples of `every` before and after it

  int first() const;  ///< number of the first time from midnight on: at `anchor` + first() * `every`; at most 0
  int last() const;   ///< number of the last time until the next midnight; at least 0
};

/// Returns the sun's positions at these times of all days, in the order of time, while the sun is above the horizon.
/// Strengths are proportional to the altitudes and sum to 1. `latitude` is in radians.
std::vector<DirectionalLight> sampled_days(double latitude, const std::vector<double>& days, const DaySamples& samples);

}  // namespace meristem
