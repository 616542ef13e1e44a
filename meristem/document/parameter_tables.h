// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// All tables of what documents may say, for editors; the manual's page on the command line (`components --json`)
/// describes its form:
///
///   {"format": 1, "components": {"leaf": {"doc", "table", ...}, ...}, "all_components": "component",
///    "link": "link", "links": {"branch": "branch_link", "crown": "crown_link"}, "document": "document", "variable":
///    "variable", "limits": "limits", "tables": {"leaf": {"doc", "rows": [{"name", "kind", "unit", "min", "max",
///    ...}]}, ...}}
///
/// A table stands once, under its name, whatever nests it. Rows that all components have stand in one of their own.
Value parameter_tables(const Registry& registry);

}  // namespace meristem
