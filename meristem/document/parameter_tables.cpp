// SPDX-License-Identifier: Apache-2.0
// Lists all parameter tables as a value for editors. Rows refer to nested tables by name, so each table is listed once,
// even if tables contain themselves.
#include "meristem/document/parameter_tables.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "meristem/document/tables.h"
#include "meristem/graph/crown_placement.h"
#include "meristem/graph/link.h"
#include "meristem/graph/placement.h"
#include "meristem/graph/table/kinds.h"
#include "meristem/graph/table/usual_range.h"

namespace meristem {

namespace {

using Object = Value::Object;
using List = Value::List;

constexpr int kForm = 1;

List texts_of(const std::vector<std::string>& texts) { return List(texts.begin(), texts.end()); }

/// The requested tables and the tables nested in them, each once.
class TableList {
 public:
  /// Adds a table and returns its name in the list. `owner` distinguishes tables of equal names. Rows that `without`
  /// also has are left out.
  std::string add(const ParameterTable& table, const std::string& owner, const ParameterTable* without = nullptr) {
    const auto known =
        std::find_if(named_.begin(), named_.end(), [&](const Named& named) { return named.table == &table; });
    if (known != named_.end()) return known->name;
    std::string name = noun_of(table);
    if (is_taken(name)) name = owner;
    named_.push_back({&table, without, name});
    return name;
  }

  Value take() {
    Object made;
    // Rows may add further tables while the list is written.
    for (std::size_t k = 0; k < named_.size(); ++k) {
      const Named named = named_[k];
      made.emplace_back(named.name, table(*named.table, named.name, named.without));
    }
    return made;
  }

 private:
  struct Named {
    const ParameterTable* table;
    const ParameterTable* without;
    std::string name;
  };

  /// Returns the name of a table: branch_link for "a branch link", leaf_texture for "a leaf's texture".
  static std::string noun_of(const ParameterTable& table) {
    std::string noun = table.name;
    for (const std::string article : {"a ", "an "}) {
      if (noun.starts_with(article)) noun.erase(0, article.size());
    }
    if (const std::size_t owner = noun.find("'s "); owner != std::string::npos) noun.erase(owner, 2);
    std::replace(noun.begin(), noun.end(), ' ', '_');
    return noun;
  }

  bool is_taken(const std::string& name) const {
    return std::any_of(named_.begin(), named_.end(), [&](const Named& named) { return named.name == name; });
  }

  Value table(const ParameterTable& table, const std::string& name, const ParameterTable* without) {
    const std::vector<Value> defaults = table.defaults();
    List rows;
    for (std::size_t k = 0; k < table.parameters.size(); ++k) {
      if (without != nullptr && without->find(table.parameters[k].name) != nullptr) continue;
      rows.push_back(row(table.parameters[k], defaults[k], name));
    }
    Object made{{"doc", table.doc}, {"rows", std::move(rows)}};
    if (!table.shorthand.empty()) made.emplace_back("shorthand", table.shorthand);
    if (!table.one_of.empty()) {
      List groups;
      for (const std::vector<std::string>& group : table.one_of) groups.emplace_back(texts_of(group));
      made.emplace_back("one_of", std::move(groups));
    }
    for (const bool is_wanted : {true, false}) {
      List pairs;
      for (const ParameterTable::Company& rule : table.company) {
        if (rule.is_wanted == is_wanted) pairs.emplace_back(List{rule.parameter, rule.other});
      }
      if (!pairs.empty()) made.emplace_back(is_wanted ? "only_with" : "never_with", std::move(pairs));
    }
    add_meanings(table, made);
    return made;
  }

  static void add_meanings(const ParameterTable& table, Object& made) {
    List only_where, without;
    for (const ParameterTable::Meaning& meaning : table.meanings) {
      if (meaning.givers.empty()) {
        without.emplace_back(Object{{"rows", texts_of(meaning.parameters)}, {"reason", meaning.reason}});
        continue;
      }
      List givers;
      for (const ParameterTable::Meaning::Giver& giver : meaning.givers) {
        Object any{{"row", giver.parameter}};
        if (!giver.values.empty()) any.emplace_back("values", giver.values);
        givers.emplace_back(std::move(any));
      }
      only_where.emplace_back(Object{{"rows", texts_of(meaning.parameters)}, {"any_of", std::move(givers)}});
    }
    if (!only_where.empty()) made.emplace_back("only_where", std::move(only_where));
    if (!without.empty()) made.emplace_back("without", std::move(without));
  }

  Value row(const Parameter& row, const Value& fallback, const std::string& table_name) {
    Object made{{"name", row.name}, {"kind", std::string(kind_name(row.kind))}, {"doc", row.doc}};
    if (row.form.unit != Unit::none) made.emplace_back("unit", std::string(unit_name(row.form.unit)));
    if (has_numbers(row)) add_numbers(row, fallback, made);
    if (row.kind == ParameterKind::curve) add_range(row.form, made);
    if (!row.choices.empty()) made.emplace_back("choices", texts_of(row.choices));
    if (!row.names.empty()) made.emplace_back("names", texts_of(row.names));
    if (row.count > 0) made.emplace_back("count", static_cast<double>(row.count));
    if (row.kind == ParameterKind::points || row.kind == ParameterKind::positions)
      made.emplace_back("together", std::string(points_form_name(row.together)));
    if (row.in_space != InSpace::none) made.emplace_back("in_space", std::string(in_space_name(row.in_space)));
    if (row.kinds != nullptr) {
      made.emplace_back("kinds", kinds(row.kinds(), table_name + "." + row.name));
    } else if (row.nested != nullptr) {
      made.emplace_back("table", add(row.nested(), table_name + "." + row.name));
    }
    const bool has_points = row.kind == ParameterKind::curve || row.kind == ParameterKind::points ||
                            row.kind == ParameterKind::positions;  // the studio has no editor for keys of points
    if (row.key_clock(true) != KeyClock::none && !has_points) made.emplace_back("keyed", true);
    if (row.required) made.emplace_back("required", true);
    if (!fallback.is_null() && !row.required) made.emplace_back("default", fallback);
    return made;
  }

  /// Lists the tables of all kinds of an element, with the key that selects the kind.
  Value kinds(const ElementKinds& kinds, const std::string& owner) {
    Object tables;
    for (const ElementKinds::Kind& kind : kinds.kinds) {
      tables.emplace_back(kind.name, add(kind.table(), owner + "." + kind.name));
    }
    return Object{{"key", kinds.key}, {"doc", kinds.key_doc}, {"tables", std::move(tables)}};
  }

  static void add_range(const NumberRange& form, Object& made) {
    if (std::isfinite(form.min)) made.emplace_back(form.above_min ? "above" : "min", form.min);
    if (std::isfinite(form.max)) made.emplace_back("max", form.max);
  }

  static void add_numbers(const Parameter& row, const Value& fallback, Object& made) {
    add_range(row.form, made);
    const bool are_points = row.kind == ParameterKind::points;
    const auto [usual, second_usual] =
        are_points ? usual_ranges_of_points(row, fallback) : std::pair(usual_range(row, fallback), UsualSpan());
    made.emplace_back("usual", List{usual.low, usual.high});
    if (row.may_vary()) made.emplace_back("varies", row.form.per_child ? "child" : "instance");
    if (!row.second) return;
    Object second;
    add_range(*row.second, second);
    second.emplace_back("usual", List{second_usual.low, second_usual.high});
    made.emplace_back("second", std::move(second));
  }

  std::vector<Named> named_;
};

Value component(const ComponentType& type, TableList& tables) {
  const bool grows = static_cast<bool>(type.grow);
  Object made{{"doc", type.doc}, {"table", tables.add(type.parameters, type.name, &component_base_table())}};
  if (type.is_camera) made.emplace_back("is_camera", true);
  if (type.makes_stems) made.emplace_back("makes_stems", true);
  if (type.is_whole_plant) made.emplace_back("is_whole_plant", true);
  if (!type.has_geometry) made.emplace_back("has_geometry", false);
  if (grows) made.emplace_back("after_growth", texts_of(rows_after_growth(type)));
  return made;
}

}  // namespace

Value parameter_tables(const Registry& registry) {
  TableList tables;
  Object components;
  for (const ComponentType& type : registry.types()) components.emplace_back(type.name, component(type, tables));
  const std::string all = tables.add(component_base_table(), "component");
  Object links{{"branch", tables.add(placement_table(), "branch")},
               {"crown", tables.add(crown_placement_table(), "crown")}};
  Object document{{"format", kForm},
                  {"components", std::move(components)},
                  {"all_components", all},
                  {"link", tables.add(link_table(), "link")},
                  {"links", std::move(links)},
                  {"document", tables.add(head_table(), "document")},
                  {"variable", tables.add(variable_table(), "variable")},
                  {"animation", tables.add(animation_table(), "animation")},
                  {"limits", tables.add(limits_table(), "limits")}};
  document.emplace_back("tables", tables.take());
  return document;
}

}  // namespace meristem
