// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/growth_direction.h"

#include <cmath>

namespace meristem {
namespace {

constexpr double kVanishing = 1e-5;  // shorter sums are rounding errors of balanced points

std::optional<DVec3> unit(DVec3 vector) {
  const double length = std::sqrt(squared_length(vector));
  if (!(length > kVanishing)) return std::nullopt;
  return vector / length;
}

}  // namespace

std::optional<DVec3> growth_direction(DVec3 pull, DVec3 bias) {
  const std::optional<DVec3> toward_points = unit(pull);
  if (!toward_points) return std::nullopt;
  return unit(*toward_points + bias);
}

}  // namespace meristem
