// SPDX-License-Identifier: Apache-2.0
// Variables that are drawn once for each instance of a component, and the names that sites are given: who may use them,
// and where.
#pragma once

#include <string>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// Whether the document's value of a variable says that it is drawn per instance.
bool is_per_instance(const Value& variable);

/// Reads those of the document's object of variables (null: it has none) into the graph, whose components have their
/// ids and whose `site_names` hold the columns of tables; appends their names there and to the reader's. Faults: a
/// component that is not there, a name that a column has, variables that need each other.
void read_instance_variables(const Value* given, Graph& graph, ParameterReader& reader);

/// Adds a fault for each component that uses a name which it is not given wherever it stands: what hangs on nothing
/// that gives it. The graph's structure is sound. Faults beyond the graph's limit have no text, since only their number
/// is shown. Throws Cancelled soon after `progress` was asked to stop; null: it cannot be stopped.
void check_given_names(const Value& root, const Graph& graph, std::vector<Diagnostic>& diagnostics,
                       const Progress* progress = nullptr);

}  // namespace meristem
