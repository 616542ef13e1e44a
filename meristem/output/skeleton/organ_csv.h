// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/measure/organ_light.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Returns the number of each organ among the organs of its component, from 0 in the plant's order.
std::vector<std::uint32_t> organ_instances(const Plant& plant);

/// Writes a table in CSV like write_skeleton_csv, one row per organ in the plant's order: `component` (id), `instance`
/// (number among the component's organs, from 0), `tree` (as trees_of_organs in measures.h), `x`, `y`, `z` (point of
/// attachment, metres), `area` (square metres), `exposure` and `irradiance` (organ_light.h). Throws
/// std::invalid_argument unless `lit` has an entry for each organ, MachineError (path, disk), Cancelled.
void write_organ_csv(const Plant& plant, const SizeLimits& limits, std::span<const LitOrgan> lit,
                     const std::string& path, Progress& progress);

}  // namespace meristem
