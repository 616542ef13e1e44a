// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/graph.h"

namespace meristem {

/// Adds a camera to a graph without one. Links the camera to all components without a parent. In each cycle that no
/// other link leads into, links it to the first component with a recursion, or else to the first component. All
/// components must have types.
void add_camera(Graph& graph, const ComponentType& camera);

}  // namespace meristem
