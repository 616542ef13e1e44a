// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/progress.h"
#include "meristem/graph/graph.h"
#include "meristem/plant/plant.h"
#include "meristem/scene/obstacle/obstacles.h"

namespace meristem {

/// Growth models keep out of obstacles; stems that are drawn, and what is drawn about them, go where they are told.
/// A warning for each component with such stems that goes into an obstacle: how much of it does, and where the first
/// of it. Leaves, and all else that hangs on stems, are not asked about. Takes some microseconds for each node near an
/// obstacle. Throws Cancelled.
std::vector<Diagnostic> obstacle_warnings(const Graph& graph, const Obstacles& obstacles, const Plant& plant,
                                          const Progress& progress);

}  // namespace meristem
