// SPDX-License-Identifier: Apache-2.0
// Drawings of a p-graph and of the i-tree that it expands into, as SVG, in the line styles of the source: child links
// thin, branch links thick, leaf links dashed, and of this project crown links dotted. A recursion's first component is
// drawn at its beginning and at its end, with doubled lines between. A component with several parents is drawn once,
// under the one that is deepest.
//
// Based on: O. Deussen: Computergenerierte Pflanzen (2003), figures 6.1 and 6.7 to 6.10.
#pragma once

#include <string>

#include "meristem/graph/graph.h"
#include "meristem/graph/instances.h"

namespace meristem {

/// Options of drawings of a graph.
struct DrawingOptions {
  bool shows_types = false;  ///< the type of each component below its name
};

/// The p-graph; its structure must be sound.
std::string draw_graph(const Graph& graph, const DrawingOptions& options = {});

/// The i-tree of the graph. An instance is called by its component, with its numbers below the line: those of the
/// multiplied instances on the way to it, and last its depth in a recursion.
std::string draw_instance_tree(const Graph& graph, const InstanceTree& tree);

}  // namespace meristem
