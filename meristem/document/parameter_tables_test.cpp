// SPDX-License-Identifier: Apache-2.0
// The tables for editors: complete, and sensible in every row of every component.
#include "meristem/document/parameter_tables.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/json.h"
#include "meristem/graph/table/usual_range.h"

namespace meristem::parameter_tables_test {

const Value& tables() {
  static const Value tables = parameter_tables(builtin_components());
  return tables;
}

const Value* row_of(const char* table, std::string_view name) {
  for (const Value& row : *tables().find("tables")->find(table)->find("rows")->list()) {
    if (*row.find("name")->text() == name) return &row;
  }
  ADD_FAILURE() << table << " has no " << name;
  return nullptr;
}

std::string text_of(const char* table, std::string_view name) { return write_json_line(*row_of(table, name)); }

void collect_tables(const ParameterTable& table, std::set<const ParameterTable*>& found) {
  if (!found.insert(&table).second) return;
  for (const Parameter& row : table.parameters) {
    if (row.nested != nullptr) collect_tables(row.nested(), found);
  }
}

void collect_numbers(const Value& value, std::vector<double>& numbers) {
  if (value.number() != nullptr) numbers.push_back(*value.number());
  if (value.list() == nullptr) return;
  for (const Value& element : *value.list()) collect_numbers(element, numbers);
}

// All tables of components.
std::set<const ParameterTable*> component_tables() {
  std::set<const ParameterTable*> found;
  for (const ComponentType& type : builtin_components().types()) collect_tables(type.parameters, found);
  return found;
}

TEST(ParameterTables, SayWhatPointsAreTogether) {
  const auto together = [](const char* table, std::string_view row) {
    return *row_of(table, row)->find("together")->text();
  };
  EXPECT_EQ(together("horn", "outline"), "polygon");
  EXPECT_EQ(together("revolution", "silhouette"), "silhouette");
  EXPECT_EQ(together("crown", "profile"), "silhouette");
  EXPECT_EQ(together("horn", "axis"), "line");
  EXPECT_EQ(together("colonize", "roots"), "apart");
  EXPECT_EQ(row_of("leaf", "outline")->find("together"), nullptr);
}

TEST(ParameterTables, GiveTheRangeOfACurveThatHasOne) {
  const Value* outline = row_of("leaf", "outline");
  EXPECT_EQ(*outline->find("min")->number(), 0);
  EXPECT_EQ(*outline->find("max")->number(), 1);
  const Value* profile = row_of("grassleaf", "profile");
  EXPECT_EQ(*profile->find("min")->number(), 0);
  EXPECT_EQ(profile->find("max"), nullptr);
  EXPECT_EQ(row_of("leaf", "profile")->find("min"), nullptr);
}

TEST(ParameterTables, GiveTheRangesOfBothNumbersOfPoints) {
  const Value* polygon = row_of("leaf", "polygon");
  EXPECT_EQ(*polygon->find("min")->number(), 0);
  EXPECT_EQ(*polygon->find("max")->number(), 1);
  EXPECT_EQ(write_json_line(*polygon->find("second")), R"({"min": -2, "max": 2, "usual": [0, 1]})");
  // Radii are at least 0, while heights may lie below the origin.
  for (const char* table : {"revolution", "crown"}) {
    const char* name = table == std::string_view("crown") ? "profile" : "silhouette";
    EXPECT_EQ(*row_of(table, name)->find("min")->number(), 0);
    EXPECT_LT(*row_of(table, name)->find("second")->find("min")->number(), 0);
  }
  EXPECT_EQ(row_of("horn", "outline")->find("second"), nullptr);
}

TEST(ParameterTables, SayOfANumberAllThatAnEditorNeeds) {
  const Value* length = row_of("leaf", "length");
  ASSERT_NE(length, nullptr);
  EXPECT_EQ(*length->find("kind")->text(), "number");
  EXPECT_EQ(*length->find("unit")->text(), "m");
  EXPECT_GT(*length->find("max")->number(), (*length->find("usual")->list())[1].number()[0]);
  EXPECT_EQ(*length->find("varies")->text(), "instance");
  EXPECT_FALSE(length->find("doc")->text()->empty());
  EXPECT_NE(length->find("default"), nullptr);
  EXPECT_EQ(*row_of("hydra", "radius")->find("varies")->text(), "child");
  EXPECT_EQ(row_of("component", "recursion")->find("varies"), nullptr);  // one number for all
}

TEST(ParameterTables, NameEachTableOnceAndReferToIt) {
  const Value::Object& named = *tables().find("tables")->object();
  std::set<std::string> names;
  for (const auto& [name, table] : named) EXPECT_TRUE(names.insert(name).second) << name;
  const auto refer = [&](const Value& name) { EXPECT_TRUE(names.contains(*name.text())) << *name.text(); };
  for (const auto& [name, table] : named) {
    for (const Value& row : *table.find("rows")->list()) {
      if (const Value* nested = row.find("table")) refer(*nested);
    }
  }
  for (const auto& [type, facts] : *tables().find("components")->object()) refer(*facts.find("table"));
  for (const auto& [kind, table] : *tables().find("links")->object()) refer(table);
  for (const char* key : {"all_components", "link", "document", "variable", "limits"}) refer(*tables().find(key));
  EXPECT_NE(text_of("crown", "union").find(R"("table": "crown")"), std::string::npos);
}

TEST(ParameterTables, HoldEveryComponentAndItsRows) {
  const Value* all = tables().find("tables")->find(*tables().find("all_components")->text())->find("rows");
  for (const ComponentType& type : builtin_components().types()) {
    const Value* facts = tables().find("components")->find(type.name);
    ASSERT_NE(facts, nullptr) << type.name;
    std::set<std::string> names;
    const Value* table = tables().find("tables")->find(*facts->find("table")->text());
    for (const Value* rows : {table->find("rows"), all}) {
      for (const Value& row : *rows->list()) names.insert(*row.find("name")->text());
    }
    if (const Value* without = table->find("without")) {
      for (const Value& rule : *without->list()) {
        for (const Value& row : *rule.find("rows")->list()) names.erase(*row.text());
      }
    }
    const std::vector<std::string> read = type.parameters.names();
    std::set<std::string> expected(read.begin(), read.end());
    expected.erase("type");
    EXPECT_EQ(names, expected) << type.name;
  }
}

TEST(ParameterTables, SayWhatIsDoneToAPlantOnceItHasGrown) {
  const Value& rows = *tables().find("components")->find("colonize")->find("after_growth");
  const auto is_told = [&](const char* name) {
    return std::ranges::any_of(*rows.list(), [&](const Value& row) { return *row.text() == name; });
  };
  EXPECT_TRUE(is_told("surface") && is_told("colour"));
  EXPECT_FALSE(is_told("crown") || is_told("frame"));
  EXPECT_EQ(tables().find("components")->find("leaf")->find("after_growth"), nullptr);
}

TEST(ParameterTables, AreReadBackFromTheirText) {
  const std::string text = write_json_line(tables());
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(write_json_line(parse_json(text)), text);
}

void expect_usual_within(const UsualSpan& span, const NumberRange& form, const std::string& where) {
  EXPECT_LT(span.low, span.high) << where;
  EXPECT_TRUE(std::isfinite(span.low) && std::isfinite(span.high)) << where;
  EXPECT_TRUE(form.above_min ? span.low > form.min : span.low >= form.min) << where << ' ' << span.low;
  EXPECT_LE(span.high, form.max) << where;
}

TEST(ComponentTables, UsualRangesHoldTheDefaultWithinTheHardRange) {
  for (const ParameterTable* table : component_tables()) {
    const std::vector<Value> defaults = table->defaults();
    for (std::size_t k = 0; k < table->parameters.size(); ++k) {
      const Parameter& row = table->parameters[k];
      if (!has_numbers(row)) continue;
      const std::string where = table->name + "." + row.name;
      if (row.second) {
        const auto [first, second] = usual_ranges_of_points(row, defaults[k]);
        expect_usual_within(first, row.form, where);
        expect_usual_within(second, *row.second, where);
        continue;
      }
      const NumberRange& form = row.form;
      expect_usual_within(usual_range(row, defaults[k]), form, where);
      // An end that the row gives itself (not NaN) includes the default.
      std::vector<double> numbers;
      collect_numbers(defaults[k], numbers);
      for (const double number : numbers) {
        EXPECT_FALSE(form.usual.low > number) << where;
        EXPECT_FALSE(form.usual.high < number) << where;
      }
      EXPECT_FALSE(form.usual.low < form.min) << where;
      EXPECT_FALSE(form.usual.high > form.max) << where;
    }
  }
}

TEST(ComponentTables, RulesOfCompanyNameRowsThatThereAre) {
  for (const ParameterTable* table : component_tables()) {
    for (const ParameterTable::Company& rule : table->company) {
      EXPECT_TRUE(table->find(rule.parameter) != nullptr && table->find(rule.other) != nullptr)
          << table->name << ": " << rule.parameter << ", " << rule.other;
    }
    for (const std::vector<std::string>& group : table->one_of) {
      for (const std::string& name : group) EXPECT_NE(table->find(name), nullptr) << table->name << ": " << name;
    }
  }
}

}  // namespace meristem::parameter_tables_test
