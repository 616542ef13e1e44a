// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// All that operations have done to the trees of a plant, or would do, in the order of the stems and then of what was
/// done.
std::vector<OperationRecord> operation_records(const Plant& plant);

/// Writes them as a table in CSV as write_skeleton_csv does, a row for each: `operation`, `act`, `iteration`, `tree`,
/// `shoot`, `rank`, `metamer`, `x`, `y`, `z`, `bud_x`, `bud_y`, `bud_z`, `bud_position_x`, `bud_position_y`,
/// `bud_position_z`, `diameter`, `metamers`, `length`, `wood`, `light`, as OperationRecord tells. Throws MachineError
/// (path, disk), Cancelled.
void write_operation_csv(const Plant& plant, const Limits& limits, const std::string& path, Progress& progress);

}  // namespace meristem
