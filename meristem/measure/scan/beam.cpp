// SPDX-License-Identifier: Apache-2.0
// The strength of a Gaussian beam within r of its axis is 1 - exp(-2 r²), so a share q beyond r means r² = -ln(q) / 2.
// The integral of -ln(q) is q - q ln(q), which gives the mean of r² over a ring in closed form.
#include "meristem/measure/scan/beam.h"

#include <cmath>

#include "meristem/base/math.h"

namespace meristem {

std::vector<Vec2> beam_offsets(int rays) {
  if (rays <= 1) return {Vec2(0)};
  const auto integral = [](double q) { return q > 0 ? q - q * math::log(q) : 0; };
  std::vector<Vec2> offsets;
  for (int k = 0; k < rays; ++k) {
    const double inner = 1 - static_cast<double>(k) / rays;
    const double outer = 1 - static_cast<double>(k + 1) / rays;
    const double distance = std::sqrt(0.5 * rays * (integral(inner) - integral(k + 1 < rays ? outer : 0)));
    const double angle = radians(kGoldenAngleDeg) * k;
    offsets.emplace_back(distance * math::cos(angle), distance * math::sin(angle));
  }
  return offsets;
}

}  // namespace meristem
