// SPDX-License-Identifier: Apache-2.0
// The component types and parameter tables as dicts.
#include <algorithm>
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include <pybind11/stl/filesystem.h>

#include "document.h"
#include "meristem/components/plugin.h"
#include "meristem/components/registry.h"
#include "meristem/document/parameter_tables.h"
#include "meristem/document/schema.h"
#include "values.h"

namespace meristem::python {

namespace {

/// Returns the rows of a table by name. A table that contains itself is listed once.
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
  for (const ComponentType& type : component_types().types()) {
    py::dict facts;
    facts["doc"] = type.doc;
    facts["parameters"] = rows_of(type.parameters, {});
    types[py::str(type.name)] = facts;
  }
  return types;
}

/// All registries. The last one is in use. Each document points into the registry that it was read with.
std::deque<Registry>& registries() {
  static std::deque<Registry> all;
  return all;
}

void load_plugin(const std::string& path) { registries().push_back(with_plugin(component_types(), path)); }

}  // namespace

const Registry& component_types() { return registries().empty() ? builtin_components() : registries().back(); }

void bind_component_types(py::module_& module) {
  module.def(
      "load_plugin", [](const std::filesystem::path& path) { load_plugin(path.string()); }, py::arg("path"),
      R"(Loads the component types of a shared library. Documents that are read afterwards may use these types.

`path` is the path of the library, such as "build/libthorn.so". It stays loaded as long as Python runs. Worker processes
must load it too: call this function in their `initializer`. Raises InputError for a file that does not exist, is not a
plug-in, was built for another version of Meristem, or has a type whose name is in use.)");
  module.def("components", &components, R"(Returns the component types and their parameters: {type: {"doc",
"parameters"}}.

Parameters are dicts by name: {"doc", "expected", "required", "default"}. Objects also have "parameters" of their
own.)");
  module.def(
      "parameter_tables", [] { return to_python(parameter_tables(component_types())); },
      R"(Returns all parameter tables for editors, a dict in the form of `meristem components --json`.

{"components": {type: {"table", ...}}, "tables": {name: {"rows": [{"name", "kind", "min", "max", "usual", ...}]}}, ...})");
  module.def(
      "schema", [] { return to_python(document_schema(component_types())); },
      "Returns the JSON Schema (draft 7) of documents, a dict.");
}

}  // namespace meristem::python
