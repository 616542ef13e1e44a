// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/progress.h"
#include "meristem/graph/graph.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/obstacle/obstacles.h"

namespace meristem {

/// Returns a warning for each component with drawn stems that enters an obstacle: how much of it enters, and where it
/// first does. Growth models avoid obstacles, but drawn stems and the shapes around them do not. Leaves and other
/// children on stems are not tested. Takes some microseconds for each node near an obstacle. Throws Cancelled.
std::vector<Diagnostic> obstacle_warnings(const Graph& graph, const Obstacles& obstacles, const Plant& plant,
                                          const Progress& progress);

}  // namespace meristem
