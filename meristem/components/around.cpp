// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/around.h"

namespace meristem {

std::vector<double> turns_around(std::uint32_t number, double arc) {
  const bool is_closed = arc >= 2 * kPi - 1e-9;
  const double gaps = is_closed ? number : number - 1.0;
  const double first = is_closed ? 0 : -0.5 * arc;
  std::vector<double> turns;
  turns.reserve(number);
  for (std::uint32_t k = 0; k < number; ++k) turns.push_back(first + (gaps > 0 ? arc * k / gaps : 0.5 * arc));
  return turns;
}

Mat3 tilted(double turn, double angle) { return rotation(kUp, turn) * rotation({1, 0, 0}, -angle); }

}  // namespace meristem
