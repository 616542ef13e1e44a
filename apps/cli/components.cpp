// SPDX-License-Identifier: Apache-2.0
// The command `components`: prints the tables of component types and of other parts of documents as text, or all tables
// as JSON. Nested tables are indented below their rows.
#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "commands.h"
#include "documents.h"
#include "meristem/document/json.h"
#include "meristem/document/parameter_tables.h"
#include "meristem/document/schema.h"
#include "meristem/document/tables.h"
#include "meristem/graph/crown_placement.h"
#include "meristem/graph/placement.h"
#include "reference.h"

namespace meristem::cli {

namespace {

void print_table(const ParameterTable& table, int indent, std::vector<const ParameterTable*> above = {}) {
  above.push_back(&table);
  const std::vector<Value> defaults = table.defaults();
  for (std::size_t k = 0; k < table.parameters.size(); ++k) {
    const Parameter& row = table.parameters[k];
    const bool nested = row.nested != nullptr;
    std::string facts = nested ? "" : row.expectation();
    if (row.required) facts += facts.empty() ? "required" : "; required";
    if (!nested && !row.required && !defaults[k].is_null()) facts += "; default " + write_json_line(defaults[k]);
    fmt::print("{:{}}{}{}\n", "", indent, row.name, facts.empty() ? "" : " - " + facts);
    fmt::print("{:{}}{}\n", "", indent + 4, row.doc);
    // The rows of a table that contains itself were printed above.
    if (nested && std::find(above.begin(), above.end(), &row.nested()) == above.end()) {
      print_table(row.nested(), indent + 4, above);
    }
  }
}

/// A part of documents other than components, with its tables.
struct Part {
  std::string name;
  std::string doc;
  std::vector<const ParameterTable*> tables;
};

std::vector<Part> other_parts() {
  return {{"link",
           "Joins two components: the child stands on the parent, along its stems or in its crown.",
           {&placement_table(), &crown_placement_table()}},
          {"variable", variable_table().doc, {&variable_table()}},
          {"document", "The top level of a document.", {&head_table()}},
          {"limits", limits_table().doc, {&limits_table()}}};
}

void print_part(const std::string& name) {
  const Registry& registry = components();
  if (const ComponentType* type = registry.find(name)) {
    fmt::print("{}: {}\n\n", type->name, type->doc);
    return print_table(type->parameters, 2);
  }
  std::vector<std::string> names = registry.names();
  for (const Part& part : other_parts()) {
    if (part.name == name) {
      fmt::print("{}: {}\n", part.name, part.doc);
      for (const ParameterTable* table : part.tables) {
        if (part.tables.size() > 1) fmt::print("\n{}: {}\n", table->name, table->doc);
        fmt::print("\n");
        print_table(*table, 2);
      }
      return;
    }
    names.push_back(part.name);
  }
  throw InputError(Diagnostic{.message = fmt::format("'{}' is not a type of component", name),
                              .expected = fmt::format("one of {}", fmt::join(names, ", ")),
                              .nearest = nearest_name(name, names)});
}

void list_components() {
  for (const ComponentType& type : components().types()) fmt::print("{:<12} {}\n", type.name, type.doc);
  for (const Part& part : other_parts()) fmt::print("{:<12} {}\n", part.name, part.doc);
}

}  // namespace

void add_components(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("components", "List component types, or one type's parameters");
  auto name = std::make_shared<std::string>();
  auto schema = std::make_shared<bool>(false);
  auto json = std::make_shared<bool>(false);
  auto markdown = std::make_shared<bool>(false);
  command->add_option("name", *name, "Component type whose parameters to list; or link, variable, document, limits")
      ->type_name("NAME");
  command->add_flag("--schema", *schema, "Print the JSON Schema of documents");
  command->add_flag("--json", *json, "Print all tables as JSON for editors")->excludes("--schema");
  command->add_flag("--markdown", *markdown, "Print all parameters as a page of the manual")
      ->excludes("--schema")
      ->excludes("--json");
  add_plugin_option(*command);
  command->footer("Example: meristem components leaf");
  command->callback([name, schema, json, markdown, &run] {
    run = [name, schema, json, markdown] {
      if (*schema) {
        fmt::print("{}", write_json(document_schema(components())));
      } else if (*json) {
        fmt::print("{}\n", write_json_line(parameter_tables(components())));
      } else if (*markdown) {
        fmt::print("{}", reference_page(components()));
      } else if (name->empty()) {
        list_components();
      } else {
        print_part(*name);
      }
    };
  });
}

}  // namespace meristem::cli
