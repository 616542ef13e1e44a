// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Returns all tables of documents, for editors. The manual's page on the command line (`components --json`) describes
/// the form:
///
///   {"format": 1, "components": {"leaf": {"doc", "table", ...}, ...}, "all_components": "component",
///    "link": "link", "links": {"branch": "branch_link", "crown": "crown_link"}, "document": "document", "variable":
///    "variable", "limits": "limits", "tables": {"leaf": {"doc", "rows": [{"name", "kind", "unit", "min", "max",
///    ...}]}, ...}}
///
/// Each table is listed once under its name, whatever other tables contain it. Rows that all components have are in a
/// separate table.
Value parameter_tables(const Registry& registry);

}  // namespace meristem
