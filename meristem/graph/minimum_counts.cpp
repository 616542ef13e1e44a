// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/minimum_counts.h"

#include <algorithm>
#include <cmath>

namespace meristem {

const Varying* KnownMembers::find(const void* member, std::size_t size) const {
  const auto begin =
      static_cast<std::size_t>(static_cast<const std::byte*>(member) - static_cast<const std::byte*>(parameters_));
  for (const Varying& varying : varyings_) {
    const std::size_t offset = varying.way.empty() ? varying.offset : varying.way[0].offset;
    if (offset >= begin && offset < begin + size) return &varying;
  }
  return nullptr;
}

double KnownMembers::minimum(const Varying* varying, double plain) {
  if (varying == nullptr) return std::floor(plain);
  if (varying->expression || varying->sample != nullptr || varying->keys != nullptr || !varying->way.empty()) return 0;
  const double min = std::clamp(std::min(varying->first, varying->last), varying->min, varying->max);
  return std::floor(min * varying->scale);
}

}  // namespace meristem
