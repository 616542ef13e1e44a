// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/minimum_counts.h"

#include <algorithm>
#include <cmath>

namespace meristem {

double KnownMembers::minimum_of(const Varying* varying, double plain) {
  if (varying == nullptr) return std::floor(plain);
  if (varying->expression || varying->sample != nullptr || varying->keys != nullptr || !varying->way.empty()) return 0;
  const double min = std::clamp(std::min(varying->first, varying->last), varying->min, varying->max);
  return std::floor(min * varying->scale);
}

}  // namespace meristem
