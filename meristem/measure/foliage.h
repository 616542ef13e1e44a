// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// The leaves of a plant. A leaf is an organ whose material is two-sided: a blade without thickness, as the components
/// `leaf` makes them (petals made so count as well); closed organs such as fruits are none.
struct Foliage {
  std::uint64_t leaves = 0;
  double area = 0;  ///< square metres, one side, the surface of the stalks included
};

/// Whether organs of this prototype are leaves.
bool is_leaf(const Plant& plant, const OrganPrototype& prototype);

/// Square metres of each organ's triangles, so of blades one side. Begins one stage of `progress`, which counts organs.
/// The same numbers on any number of threads.
std::vector<double> organ_areas(const Plant& plant, Progress& progress);

/// Begins one stage of `progress`, which counts organs. The same sums on any number of threads.
Foliage measure_foliage(const Plant& plant, Progress& progress);

}  // namespace meristem
