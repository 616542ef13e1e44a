// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Reports keys that have no effect because of the links: a recursion that no link closes, and angles of children that
/// head along their stem anyway. `root` is the tree of the document that the graph was read from without faults.
void check_silent_keys(const Value& root, const Graph& graph, std::vector<Diagnostic>& diagnostics);

}  // namespace meristem
