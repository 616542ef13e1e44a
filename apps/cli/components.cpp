// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "commands.h"
#include "meristem/components/registry.h"
#include "meristem/document/json.h"
#include "meristem/document/schema.h"
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
    // A table that contains itself was printed above.
    if (nested && std::find(above.begin(), above.end(), &row.nested()) == above.end()) {
      print_table(row.nested(), indent + 4, above);
    }
  }
}

void print_component(const std::string& name) {
  const Registry& registry = builtin_components();
  const ComponentType* type = registry.find(name);
  if (type == nullptr) {
    const std::vector<std::string> names = registry.names();
    throw InputError(Diagnostic{.message = fmt::format("'{}' is not a type of component", name),
                                .expected = fmt::format("one of {}", fmt::join(names, ", ")),
                                .nearest = nearest_name(name, names)});
  }
  fmt::print("{}: {}\n\n", type->name, type->doc);
  print_table(type->parameters, 2);
}

void list_components() {
  for (const ComponentType& type : builtin_components().types()) fmt::print("{:<12} {}\n", type.name, type.doc);
}

}  // namespace

void add_components(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("components", "List the types of components, or one type's parameters");
  auto name = std::make_shared<std::string>();
  auto schema = std::make_shared<bool>(false);
  auto markdown = std::make_shared<bool>(false);
  command->add_option("name", *name, "A type, for its parameters")->type_name("NAME");
  command->add_flag("--schema", *schema, "Print the JSON Schema of documents");
  command->add_flag("--markdown", *markdown, "Print all parameters as a page of the manual")->excludes("--schema");
  command->footer("Example: meristem components leaf");
  command->callback([name, schema, markdown, &run] {
    run = [name, schema, markdown] {
      if (*schema) {
        fmt::print("{}", write_json(document_schema(builtin_components())));
      } else if (*markdown) {
        fmt::print("{}", reference_page(builtin_components()));
      } else if (name->empty()) {
        list_components();
      } else {
        print_component(*name);
      }
    };
  });
}

}  // namespace meristem::cli
