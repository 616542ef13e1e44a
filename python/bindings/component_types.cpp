// SPDX-License-Identifier: Apache-2.0
// What documents may be made of, as dicts.
#include <algorithm>
#include <vector>

#include "document.h"
#include "meristem/components/registry.h"
#include "meristem/document/parameter_tables.h"
#include "meristem/document/schema.h"
#include "values.h"

namespace meristem::python {

namespace {

/// The rows of a table by their names. A table that contains itself is given once.
py::dict rows_of(const ParameterTable& table, std::vector<const ParameterTable*> above) {
  above.push_back(&table);
  const std::vector<Value> defaults = table.defaults();
  py::dict rows;
  for (std::size_t k = 0; k < table.parameters.size(); ++k) {
    const Parameter& row = table.parameters[k];
    py::dict facts;
    facts["doc"] = row.doc;
    facts["expected"] = row.expectation();
    facts["required"] = row.required;
    facts["default"] = to_python(defaults[k]);
    if (row.nested != nullptr && std::find(above.begin(), above.end(), &row.nested()) == above.end()) {
      facts["parameters"] = rows_of(row.nested(), above);
    }
    rows[py::str(row.name)] = facts;
  }
  return rows;
}

py::dict components() {
  py::dict types;
  for (const ComponentType& type : builtin_components().types()) {
    py::dict facts;
    facts["doc"] = type.doc;
    facts["parameters"] = rows_of(type.parameters, {});
    types[py::str(type.name)] = facts;
  }
  return types;
}

}  // namespace

void bind_component_types(py::module_& module) {
  module.def("components", &components, R"(The types of components and their parameters: {type: {"doc", "parameters"}}.

Each parameter, by its name: {"doc", "expected", "required", "default"}, objects also have "parameters" of their own.)");
  module.def(
      "parameter_tables", [] { return to_python(parameter_tables(builtin_components())); },
      R"(All tables of what documents may say, for editors, a dict in the form of `meristem components --json`.

{"components": {type: {"table", ...}}, "tables": {name: {"rows": [{"name", "kind", "min", "max", "usual", ...}]}}, ...})");
  module.def(
      "schema", [] { return to_python(document_schema(builtin_components())); },
      "The JSON Schema (draft 7) of documents, a dict.");
}

}  // namespace meristem::python
