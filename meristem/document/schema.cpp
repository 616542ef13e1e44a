// SPDX-License-Identifier: Apache-2.0
// Writes the JSON Schema (draft 7) of documents from the parameter tables. Each row becomes a schema by its kind, and
// each rule between rows a condition. Tables that contain themselves become named definitions. The schema accepts what
// the reader accepts wherever JSON Schema can express it.
#include "meristem/document/schema.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/document/tables.h"
#include "meristem/graph/placement.h"
#include "meristem/graph/table/kinds.h"

namespace meristem {

namespace {

using Object = Value::Object;
using List = Value::List;

Object typed(const char* type) { return {{"type", type}}; }

void add_bounds(Object& schema, const NumberRange& form) {
  if (std::isfinite(form.min)) schema.emplace_back(form.above_min ? "exclusiveMinimum" : "minimum", form.min);
  if (std::isfinite(form.max)) schema.emplace_back("maximum", form.max);
}

Value number_schema(const char* type, const NumberRange& form) {
  Object schema = typed(type);
  add_bounds(schema, form);
  return schema;
}

Value list_of(Value element, std::size_t low, std::size_t high) {
  Object schema = typed("array");
  schema.emplace_back("items", std::move(element));
  schema.emplace_back("minItems", static_cast<double>(low));
  if (high > 0) schema.emplace_back("maxItems", static_cast<double>(high));
  return schema;
}

Value any_of(List schemas) { return Object{{"anyOf", std::move(schemas)}}; }

Value closed_object(Object properties, List required) {
  Object schema = typed("object");
  schema.emplace_back("properties", std::move(properties));
  if (!required.empty()) schema.emplace_back("required", std::move(required));
  schema.emplace_back("additionalProperties", false);
  return schema;
}

/// The schemas of tables that contain themselves, each once, by name.
struct Definitions {
  std::vector<std::string> begun;  // names that are defined, or are about to be
  Object made;
};

/// Writes tables as schemas. In a component, numbers may vary from instance to instance.
class SchemaWriter {
 public:
  SchemaWriter(bool varies, Definitions& definitions) : varies_(varies), definitions_(definitions) {}

  Value table(const ParameterTable& table, Object properties = {}, List required = {}) const {
    const std::vector<Value> defaults = table.defaults();
    for (std::size_t k = 0; k < table.parameters.size(); ++k) {
      const Parameter& row = table.parameters[k];
      Value schema = parameter(row);
      schema.object()->emplace_back("description", description(row));
      if (!defaults[k].is_null() && !row.required) schema.object()->emplace_back("default", defaults[k]);
      properties.emplace_back(row.name, std::move(schema));
      if (row.required) required.emplace_back(row.name);
    }
    Value schema = closed_object(std::move(properties), std::move(required));
    for (const std::vector<std::string>& group : table.one_of) {
      List alternatives;
      for (const std::string& name : group) alternatives.emplace_back(Object{{"required", List{name}}});
      schema.object()->emplace_back("oneOf", std::move(alternatives));
    }
    add_company(table, *schema.object());
    add_meanings(table, *schema.object());
    schema.object()->emplace_back("description", table.doc);
    if (table.shorthand.empty()) return schema;
    return any_of({parameter(*table.find(table.shorthand)), std::move(schema)});
  }

 private:
  static void add_company(const ParameterTable& table, Object& schema) {
    Object dependencies;
    List never;
    for (const ParameterTable::Company& rule : table.company) {
      if (rule.is_wanted) {
        dependencies.emplace_back(rule.parameter, List{rule.other});
      } else {
        never.emplace_back(Object{{"required", List{rule.parameter, rule.other}}});
      }
    }
    if (!dependencies.empty()) schema.emplace_back("dependencies", std::move(dependencies));
    if (!never.empty()) schema.emplace_back("not", any_of(std::move(never)));
  }

  static void add_meanings(const ParameterTable& table, Object& schema) {
    List rules;
    for (const ParameterTable::Meaning& meaning : table.meanings) {
      if (meaning.givers.empty()) continue;
      List given;
      for (const std::string& row_path : meaning.parameters) given.push_back(given_schema(row_path));
      List cases;
      cases.emplace_back(Object{{"not", any_of(std::move(given))}});
      for (const auto& giver : meaning.givers) {
        cases.push_back(giver.values.empty() ? given_schema(giver.parameter)
                                             : value_schema(table, giver.parameter, giver.values));
      }
      rules.push_back(any_of(std::move(cases)));
    }
    if (!rules.empty()) schema.emplace_back("allOf", std::move(rules));
  }

  /// Splits a path such as "surface.style" into its first name and the rest.
  static std::pair<std::string, std::string> first_of(const std::string& row_path) {
    const std::size_t dot = row_path.find('.');
    return {row_path.substr(0, dot), dot == std::string::npos ? std::string() : row_path.substr(dot + 1)};
  }

  /// Returns the member at a path, or a null value.
  static Value member_at(const Value& value, const std::string& row_path) {
    const auto [name, rest] = first_of(row_path);
    const Value* member = value.find(name);
    if (member == nullptr) return {};
    return rest.empty() ? *member : member_at(*member, rest);
  }

  /// Returns the schema of an object with a value at the path.
  static Value given_schema(const std::string& row_path) {
    const auto [name, rest] = first_of(row_path);
    Object schema = typed("object");
    schema.emplace_back("required", List{Value(name)});
    if (!rest.empty()) schema.emplace_back("properties", Object{{name, given_schema(rest)}});
    return schema;
  }

  /// Returns the schema of an object whose parameter at the path has one of the values, given or by default. The short
  /// form of a nested object is not covered: only the reader knows it.
  static Value value_schema(const ParameterTable& table, const std::string& row_path, const List& values) {
    const auto [name, rest] = first_of(row_path);
    const Parameter* row = table.find(name);
    if (row == nullptr || (!rest.empty() && row->kind != ParameterKind::object)) return Object{};
    Value usual = table.defaults()[static_cast<std::size_t>(row - table.parameters.data())];
    Value wanted = Object{{"enum", values}};
    if (!rest.empty()) {
      wanted = any_of({Object{{"not", typed("object")}}, value_schema(row->nested(), rest, values)});
      usual = member_at(usual, rest);
    }
    Object schema{{"properties", Object{{name, std::move(wanted)}}}};
    // A parameter that is not given has its default.
    if (std::ranges::find(values, usual) == values.end()) schema.emplace_back("required", List{Value(name)});
    return schema;
  }

  /// Returns a nested table's schema. Returns a reference to its definition if the table contains itself.
  Value nested(const ParameterTable& nested_table) const {
    if (!nested_table.contains_itself()) return table(nested_table);
    const std::string noun = nested_table.name.substr(nested_table.name.find(' ') + 1);
    const std::string name = varies_ ? noun : "fixed_" + noun;
    std::vector<std::string>& begun = definitions_.begun;
    if (std::find(begun.begin(), begun.end(), name) == begun.end()) {
      begun.push_back(name);
      Value schema = table(nested_table);
      definitions_.made.emplace_back(name, std::move(schema));
    }
    return Object{{"allOf", List{Object{{"$ref", "#/definitions/" + name}}}}};
  }

  /// Returns the schema of an element with several kinds. Each kind allows only its own rows.
  Value of_kinds(const ElementKinds& kinds) const {
    List alternatives;
    for (const ElementKinds::Kind& kind : kinds.kinds) {
      const Object says{{"const", kind.name}, {"description", kinds.key_doc}};
      alternatives.push_back(table(kind.table(), {{kinds.key, says}}, {kinds.key}));
    }
    return Object{{"oneOf", std::move(alternatives)}};
  }

  static std::string description(const Parameter& row) {
    if (row.form.unit == Unit::none) return row.doc;
    return row.doc + " Unit: " + std::string(unit_name(row.form.unit)) + ".";
  }

  Value number(const char* type, const NumberRange& form) const {
    List forms{number_schema(type, form), Object{{"type", "string"}, {"description", "An expression."}}};
    if ((varies_ || form.per_child || form.per_site) && !form.fixed) {
      const Value one = any_of({number_schema(type, form), typed("string")});
      const Value range = list_of(one, 2, 2);
      const Value file = closed_object({{"file", typed("string")}, {"column", typed("string")}}, {"file", "column"});
      forms.push_back(range);
      forms.push_back(closed_object({{"range", range}, {"apply", typed("string")}}, {}));
      forms.push_back(closed_object(
          {{"sample", any_of({list_of(one, 1, 0), file})}, {"smooth", typed("boolean")}, {"apply", typed("string")}},
          {"sample"}));
    }
    return any_of(std::move(forms));
  }

  static Value plain_number(const NumberRange& form) {
    return any_of({number_schema("number", form), typed("string")});
  }

  static Value points(const NumberRange& form, const std::optional<NumberRange>& second = {}) {
    if (!second) return list_of(list_of(plain_number(form), 2, 2), 1, 0);
    return list_of(list_of(List{plain_number(form), plain_number(*second)}, 2, 2), 1, 0);
  }

  Value parameter(const Parameter& row) const {
    switch (row.kind) {
      case ParameterKind::number:
        return number("number", row.form);
      case ParameterKind::integer:
        return number(row.form.counts ? "number" : "integer", row.form);
      case ParameterKind::boolean:
        return typed("boolean");
      case ParameterKind::text:
      case ParameterKind::file:
      case ParameterKind::condition:
        return typed("string");
      case ParameterKind::formula:
        return any_of({typed("number"), typed("string")});
      case ParameterKind::lines:
        return any_of({typed("string"), list_of(typed("string"), 0, 0)});
      case ParameterKind::choice:
        return Object{{"enum", List(row.choices.begin(), row.choices.end())}};
      case ParameterKind::integers:
        return list_of(any_of({number_schema("integer", row.form), typed("string")}), row.count, row.count);
      case ParameterKind::vector:
        return list_of(number("number", row.form), 3, 3);
      case ParameterKind::facing:
        return any_of({list_of(number("number", row.form), 3, 3), Object{{"const", "surface"}}});
      case ParameterKind::colour:
        return colour();
      case ParameterKind::colours:
        return list_of(colour(), 1, 0);
      case ParameterKind::curve:
        return closed_object({{"curve", points({})}, {"kind", Object{{"enum", List{"spline", "linear"}}}}}, {"curve"});
      case ParameterKind::points:
        return points(row.form, row.second);
      case ParameterKind::positions:
        return list_of(list_of(plain_number(row.form), 3, 3), 1, 0);
      case ParameterKind::selection:
        return selection();
      case ParameterKind::box:
        return list_of(list_of(number("number", row.form), 3, 3), 2, 2);
      case ParameterKind::object:
        return nested(row.nested());
      case ParameterKind::list:
        return list_of(row.kinds != nullptr ? of_kinds(row.kinds()) : nested(row.nested()), 0, 0);
      case ParameterKind::map: {
        Object schema = typed("object");
        schema.emplace_back("additionalProperties", nested(row.nested()));
        return schema;
      }
    }
    return Object{};
  }

  static Value colour() { return Object{{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}}; }

  static Value selection() {
    const Value instance = number_schema("integer", {.min = 0, .max = 4294967295.0});
    const Value range = list_of(any_of({instance, typed("string")}), 2, 2);
    return list_of(any_of({instance, typed("string"), range}), 0, 0);
  }

  bool varies_;
  Definitions& definitions_;
};

Value component_schema(const Registry& registry, Definitions& definitions) {
  List alternatives;
  for (const ComponentType& type : registry.types()) {
    alternatives.push_back(
        SchemaWriter(true, definitions).table(type.parameters, {{"type", Object{{"const", type.name}}}}, {"type"}));
  }
  return Object{{"oneOf", std::move(alternatives)}};
}

Value link_schema(const SchemaWriter& writer) {
  const Value id = typed("string");
  const auto ends = [&](Value kind) { return Object{{"from", id}, {"to", id}, {"kind", std::move(kind)}}; };
  const Value plain = closed_object(ends(Object{{"enum", List{"child", "leaf"}}}), {"from", "to"});
  const auto placed = [&](const ParameterTable& table, const char* kind) {
    return writer.table(table, ends(Object{{"const", kind}}), {"from", "to", "kind"});
  };
  return any_of(
      {list_of(id, 2, 2), plain, placed(placement_table(), "branch"), placed(crown_placement_table(), "crown")});
}

/// Returns the schema of the animation's keys by path. The values of keys are described by the rows of their
/// parameters.
Value keys_schema() {
  const Value time = number_schema("number", {.min = 0});
  const Value way = Object{{"enum", List{"linear", "smooth", "step"}}};
  const Value key = Object{{"type", "array"}, {"items", List{time, Object{}, way}}, {"minItems", 2}, {"maxItems", 3}};
  Object schema = typed("object");
  schema.emplace_back("description", "Keys [time, value, way] of parameters, by their paths.");
  schema.emplace_back("additionalProperties", list_of(key, 1, 0));
  return schema;
}

/// Returns the rule that a `recursion` needs a link that leads back: a document with a recursion must have links, or
/// components that place others.
Value recursion_rule(const Registry& registry) {
  const auto all_components = [](Value each) {
    return Object{{"properties", Object{{"components", Object{{"additionalProperties", std::move(each)}}}}}};
  };
  List placers;
  for (const ComponentType& type : registry.types()) {
    if (type.placed) placers.emplace_back(type.name);
  }
  const Value no_placer = Object{{"properties", Object{{"type", Object{{"not", Object{{"enum", placers}}}}}}}};
  const Value some_links =
      Object{{"required", List{"links"}}, {"properties", Object{{"links", Object{{"minItems", 1}}}}}};
  List cases{some_links, all_components(Object{{"not", Object{{"required", List{"recursion"}}}}})};
  if (!placers.empty()) cases.emplace_back(Object{{"not", all_components(no_placer)}});
  return any_of(std::move(cases));
}

}  // namespace

Value document_schema(const Registry& registry) {
  Definitions definitions;
  const SchemaWriter writer(false, definitions);
  Object components = typed("object");
  components.emplace_back("propertyNames", Object{{"pattern", "^[A-Za-z0-9_]+$"}});
  components.emplace_back("additionalProperties", component_schema(registry, definitions));
  components.emplace_back("minProperties", 1);
  Object variables = typed("object");
  variables.emplace_back("additionalProperties", writer.table(variable_table()));

  Object properties{{"variables", std::move(variables)},
                    {"components", std::move(components)},
                    {"links", list_of(link_schema(writer), 0, 0)},
                    {"animation", writer.table(animation_table(), {{"keys", keys_schema()}})},
                    {"limits", writer.table(limits_table())}};
  const Value head = writer.table(head_table(), std::move(properties), {"components"});

  Object schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Meristem plant document"}};
  if (!definitions.made.empty()) schema.emplace_back("definitions", std::move(definitions.made));
  schema.insert(schema.end(), head.object()->begin(), head.object()->end());
  const auto rules = std::ranges::find(schema, "allOf", &Value::Member::first);
  if (rules == schema.end()) {
    schema.emplace_back("allOf", List{recursion_rule(registry)});
  } else {
    rules->second.list()->push_back(recursion_rule(registry));
  }
  return schema;
}

}  // namespace meristem
