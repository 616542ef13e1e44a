// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/light/sampled_days.h"

#include <cmath>

#include "meristem/scene/light/sun.h"

namespace meristem {

int DaySamples::first() const { return -static_cast<int>(std::floor(anchor / every)); }

int DaySamples::last() const { return static_cast<int>(std::floor((24 - anchor) / every)); }

std::vector<DirectionalLight> sampled_days(double latitude, const std::vector<double>& days,
                                           const DaySamples& samples) {
  std::vector<DirectionalLight> positions;
  double sum = 0;
  for (const double day : days) {
    for (int k = samples.first(); k <= samples.last(); ++k) {
      // Leave out the second midnight, which equals the first on the polar day.
      const double hour = samples.anchor + k * samples.every;
      if (hour >= 24) continue;
      const SkyDirection sun = sun_position(latitude, day, hour);
      if (!(sun.altitude > 0)) continue;
      positions.push_back({unit_vector(sun), sun.altitude});
      sum += sun.altitude;
    }
  }
  for (DirectionalLight& position : positions) position.strength /= sum;
  return positions;
}

}  // namespace meristem
