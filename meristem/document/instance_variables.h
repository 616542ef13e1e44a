// SPDX-License-Identifier: Apache-2.0
// Variables that are drawn once for each instance of a component. Checks of the names that sites get: which components
// may use them.
#pragma once

#include <string>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// Returns true if a variable's value in the document is drawn per instance.
bool is_per_instance(const Value& variable);

/// Reads the variables that are drawn per instance into the graph, and adds their names to the graph and to the reader.
/// `given` is the document's object of variables, or null. The graph's components must have their ids, and `site_names`
/// must hold the columns of tables. Reports a component that does not exist, a name that a column has, and variables
/// that depend on each other.
void read_instance_variables(const Value* given, Graph& graph, ParameterReader& reader);

/// Reports each component that uses a name that it does not get at every position: somewhere no component above it
/// gives the name. The graph's structure must be sound. Faults beyond the graph's limit have no text, since only their
/// number is shown. Throws Cancelled soon after `progress` was asked to stop. Null: it cannot be stopped.
void check_given_names(const Value& root, const Graph& graph, std::vector<Diagnostic>& diagnostics,
                       const Progress* progress = nullptr);

}  // namespace meristem
