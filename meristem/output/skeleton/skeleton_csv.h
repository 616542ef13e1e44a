// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/limits.h"
#include "meristem/base/progress.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Writes the skeletons of `plant` as a table in CSV (RFC 4180, lines end with a line feed): a line with the names of
/// the columns, then one line per node, in the order and with the names of SkeletonTable. `component` is the id. A
/// field is empty if a node has no parent or a value is unknown. Numbers have enough digits to restore the exact float.
/// Streams: memory beyond the plant and the labels of its axes stays below 64 MB. The file appears whole or not at all.
/// "-" is standard output. Throws MachineError (path, disk), Cancelled.
void write_skeleton_csv(const Plant& plant, const SizeLimits& limits, const std::string& path, Progress& progress);

}  // namespace meristem
