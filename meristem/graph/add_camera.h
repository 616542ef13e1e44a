// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/graph/graph.h"

namespace meristem {

/// Adds a camera to a graph without one. Links the camera to all components without a parent. In each cycle that no
/// other link leads into, links it to the first component with a recursion, or else to the first component. A recursion
/// is above 1, or given by the document: `has_recursion` is then true for the component. All components must have
/// types.
void add_camera(Graph& graph, const ComponentType& camera, const std::vector<bool>& has_recursion = {});

}  // namespace meristem
