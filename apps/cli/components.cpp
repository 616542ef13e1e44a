// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "commands.h"
#include "meristem/components/registry.h"
#include "meristem/document/json.h"
#include "meristem/document/schema.h"

namespace meristem::cli {

namespace {

/// One line of JSON, for defaults.
std::string compact(const Value& value) {
  std::string text = write_json(value);
  std::string line;
  bool blank = false;
  for (const char c : text) {
    if (c == '\n' || c == ' ') {
      blank = true;
      continue;
    }
    if (blank && !line.empty() && line.back() != '[' && line.back() != '{' && c != ']' && c != '}') line += ' ';
    blank = false;
    line += c;
  }
  return line;
}

void print_table(const ParameterTable& table, int indent) {
  const std::vector<Value> defaults = table.defaults();
  for (std::size_t k = 0; k < table.parameters.size(); ++k) {
    const Parameter& row = table.parameters[k];
    const bool nested = row.kind == ParameterKind::object || row.kind == ParameterKind::list;
    std::string facts = nested ? "" : row.expectation();
    if (row.required) facts += facts.empty() ? "required" : "; required";
    if (!nested && !row.required && !defaults[k].is_null()) facts += "; default " + compact(defaults[k]);
    fmt::print("{:{}}{}{}\n", "", indent, row.name, facts.empty() ? "" : " - " + facts);
    fmt::print("{:{}}{}\n", "", indent + 4, row.doc);
    if (nested) print_table(*row.nested, indent + 4);
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
  command->add_option("name", *name, "A type, for its parameters")->type_name("NAME");
  command->add_flag("--schema", *schema, "Print the JSON Schema of documents");
  command->footer("Example: meristem components leaf");
  command->callback([name, schema, &run] {
    run = [name, schema] {
      if (*schema) {
        fmt::print("{}", write_json(document_schema(builtin_components())));
      } else if (name->empty()) {
        list_components();
      } else {
        print_component(*name);
      }
    };
  });
}

}  // namespace meristem::cli
