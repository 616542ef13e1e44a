// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/graph.h"

namespace meristem {

/// Gives a graph without a camera one, with links to all components without a parent, and to one of each circle of
/// components that nothing else leads into: the first that recurses, else the first. All components have types.
void add_camera(Graph& graph, const ComponentType& camera);

}  // namespace meristem
