// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/progress.h"
#include "meristem/graph/growth_traces.h"

namespace meristem {

/// Writes the attraction points of all recorded growths as a table in CSV, for placed plants at each of their places.
/// Columns: component, instance, number, x, y, z, state and used_in, at the present step of the plants. `used_in` is
/// the step in which a point was used up, or 0. The file appears whole under its name, or not at all. Throws InputError
/// if the points were not recorded (GrowthView::wish), MachineError, Cancelled.
void write_points_csv(const GrowthTraces& traces, const std::string& path, Progress& progress);

}  // namespace meristem
