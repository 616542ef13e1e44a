// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/operation_record.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Returns everything that operations have done to the trees of a plant, or would do. The order is by stem, then by
/// time.
std::vector<OperationRecord> operation_records(const Plant& plant);

/// Writes the records as a table in CSV like write_skeleton_csv, one row each: `operation`, `act`, `iteration`, `tree`,
/// `shoot`, `rank`, `metamer`, `x`, `y`, `z`, `bud_x`, `bud_y`, `bud_z`, `bud_position_x`, `bud_position_y`,
/// `bud_position_z`, `diameter`, `metamers`, `length`, `wood`, `light`. OperationRecord describes the columns. Throws
/// MachineError (path, disk), Cancelled.
void write_operation_csv(const Plant& plant, const SizeLimits& limits, const std::string& path, Progress& progress);

}  // namespace meristem
