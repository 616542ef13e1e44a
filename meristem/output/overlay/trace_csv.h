// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "meristem/base/progress.h"
#include "meristem/graph/growth_traces.h"

namespace meristem {

/// What becomes of the attraction points of all traced growths, those of placed plants at each place, as a table in
/// CSV: component, instance, number, x, y, z, state and used_in at the step that the plants stand at. `used_in` is the
/// step in which a point was used up, 0 where it was not. The file appears whole under its name, or not at all. Throws
/// InputError where the points were not recorded (GrowthView::wish), MachineError, Cancelled.
void write_points_csv(const GrowthTraces& traces, const std::string& path, Progress& progress);

}  // namespace meristem
