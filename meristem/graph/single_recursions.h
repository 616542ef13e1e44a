// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "meristem/graph/graph.h"

namespace meristem {

/// Analyses the structure as analyse_structure() of graph.h does. `may_be_single` is true for each component whose
/// document gives a "recursion". It may be 1, for example by a variable. The links back to the component then lead
/// nowhere.
void analyse_structure(Graph& graph, const std::vector<bool>& may_be_single, std::vector<Diagnostic>& diagnostics,
                       const Progress* progress);

}  // namespace meristem
