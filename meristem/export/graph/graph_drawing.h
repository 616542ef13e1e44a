// SPDX-License-Identifier: Apache-2.0
// Draws a p-graph, and the i-tree to which it expands, as SVG. Line styles follow the source: child links are thin,
// branch links thick, leaf links dashed. In addition, crown links are dotted. The first component of a recursion is
// drawn at the beginning and at the end, with doubled lines between. A component with several parents is drawn once,
// under its deepest parent.
//
// Based on: O. Deussen: Computergenerierte Pflanzen (2003), figures 6.1 and 6.7 to 6.10.
#pragma once

#include <string>
#include <vector>

#include "meristem/export/graph/affected.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/instances.h"

namespace meristem {

/// Options of graph drawings.
struct DrawingOptions {
  bool shows_types = false;            ///< if true, shows the type of each component below its name
  std::vector<GraphEffect> effects{};  ///< highlights components that a value affects, see affected_by(); empty: none
};

/// Draws the p-graph, whose structure must be valid.
std::string draw_graph(const Graph& graph, const DrawingOptions& options = {});

/// Draws the i-tree of the graph. The label of an instance is its component, with numbers below the line: the numbers
/// of the multiplied instances on the path to it, then its depth in a recursion.
std::string draw_instance_tree(const Graph& graph, const InstanceTree& tree);

}  // namespace meristem
