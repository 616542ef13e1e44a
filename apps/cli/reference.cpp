// SPDX-License-Identifier: Apache-2.0
// Writes the manual's page of parameters from the tables: a Markdown table for each component and part of documents.
// Nested tables follow their row with full names.
#include "reference.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/markdown.h"
#include "meristem/document/json.h"
#include "meristem/document/tables.h"
#include "meristem/export/scan/scan_request.h"
#include "meristem/graph/link.h"

namespace meristem::cli {

namespace {

constexpr const char* kBegin = R"page(# Components and their parameters

This page is made from the program's own tables by `meristem components --markdown`.

A default is what counts when the parameter is not given; where the column is empty, the program chooses or nothing
happens. A parameter that *varies* may differ from instance to instance: besides a number it takes a range such as
`[0.2, 0.5]`, an expression such as `"20 + 15*rand(-1,1)"`, or both (see [the document](document.md)). One that varies
*per child* takes the same, and differs among the children that each instance makes. The others take a number or an
expression of numbers and the document's variables. A number, a vector, a colour, a choice and a switch may have
[keys](animation.md#keys); those of a parameter that varies follow each instance's own clock.

)page";

/// Whether a table's page has a column on numbers that differ between instances.
enum class Variation { none, as_stated };

/// Returns the text in the column "varies" of a row.
std::string variation_of(const Parameter& row) {
  if (!row.may_vary()) return "";
  return row.form.per_child ? "per child" : "yes";
}

class Page {
 public:
  void text(std::string_view text) { out_ += text; }
  void heading(std::string_view name, std::string_view doc) {
    fmt::format_to(std::back_inserter(out_), "## {}\n\n{}\n\n", name, doc);
  }

  /// Writes a table. Rows that `without` also has are described elsewhere and left out.
  void table(const ParameterTable& table, Variation variation, const ParameterTable* without = nullptr) {
    has_column_ = variation == Variation::as_stated;
    text(has_column_ ? "| parameter | value | default | varies | meaning |\n| --- | --- | --- | --- | --- |\n"
                     : "| parameter | value | default | meaning |\n| --- | --- | --- | --- |\n");
    rows(table, "", variation, without);
    text("\n");
  }

  std::string take() { return std::move(out_); }

 private:
  /// Writes the rows of a table. The rows of a nested table follow their row, under their full names.
  void rows(const ParameterTable& table, const std::string& above, Variation variation, const ParameterTable* without) {
    const std::vector<Value> defaults = table.defaults();
    for (std::size_t k = 0; k < table.parameters.size(); ++k) {
      const Parameter& row = table.parameters[k];
      if (without != nullptr && without->find(row.name) != nullptr) continue;
      const bool is_nested = row.nested != nullptr;
      std::string fallback;
      if (row.required) {
        fallback = "required";
      } else if (!is_nested && !defaults[k].is_null()) {
        fallback = "`" + write_json_line(defaults[k]) + "`";
      }
      write({"`" + above + row.name + "`", value(row), std::move(fallback)});
      if (has_column_) write_cell(variation == Variation::as_stated ? variation_of(row) : "");
      fmt::format_to(std::back_inserter(out_), "{} |\n", markdown_cell(row.doc));
      if (!is_nested) continue;
      // The rows of a table that contains itself were written above.
      if (std::find(open_.begin(), open_.end(), &row.nested()) != open_.end()) continue;
      open_.push_back(&row.nested());
      rows(row.nested(), fmt::format("{}{}{}.", above, row.name, element(row.kind)), variation, nullptr);
      open_.pop_back();
    }
  }

  /// Returns the text between the name of a list or map and the name of a parameter in it.
  static std::string_view element(ParameterKind kind) {
    return kind == ParameterKind::list ? "[]" : kind == ParameterKind::map ? ".*" : "";
  }

  std::string value(const Parameter& row) const {
    if (row.nested == nullptr) return row.expectation();
    const bool stands_above = std::find(open_.begin(), open_.end(), &row.nested()) != open_.end();
    const std::string what = stands_above ? row.nested().name.substr(row.nested().name.find(' ') + 1) : "object";
    if (row.kind == ParameterKind::list) return fmt::format("a list of {}s", what);
    if (row.kind == ParameterKind::map) return fmt::format("an object of names and {}s", what);
    if (row.nested().shorthand.empty()) return fmt::format("an {}", what);
    return fmt::format("an {}, or `{}` alone", what, row.nested().shorthand);
  }

  void write(const std::vector<std::string>& cells) {
    out_ += "| ";
    for (const std::string& text : cells) write_cell(text);
  }
  void write_cell(const std::string& text) { fmt::format_to(std::back_inserter(out_), "{} | ", markdown_cell(text)); }

  std::string out_;
  bool has_column_ = false;                  // whether the table has the column "varies"
  std::vector<const ParameterTable*> open_;  // nested tables whose rows are being written
};

}  // namespace

std::string reference_page(const Registry& registry) {
  Page page;
  page.text(kBegin);
  for (const ComponentType& type : registry.types()) {
    page.heading(type.name, type.doc);
    page.table(type.parameters, Variation::as_stated, &component_base_table());
  }
  page.heading("All components", component_base_table().doc);
  page.table(component_base_table(), Variation::as_stated);
  page.heading("Links", link_table().doc);
  page.table(link_table(), Variation::none);
  page.heading("Branch links", placement_table().doc);
  page.table(placement_table(), Variation::none);
  page.heading("Crown links", crown_placement_table().doc);
  page.table(crown_placement_table(), Variation::none);
  page.heading("Top level of a document", head_table().doc);
  page.table(head_table(), Variation::none);
  page.heading("Variables", variable_table().doc);
  page.table(variable_table(), Variation::none);
  page.heading("Animation", animation_table().doc);
  page.table(animation_table(), Variation::none);
  page.heading("Limits", limits_table().doc);
  page.table(limits_table(), Variation::none);
  page.heading("Scans", scan_table().doc);
  page.table(scan_table(), Variation::none);
  std::string text = page.take();
  text.pop_back();
  return text;
}

}  // namespace meristem::cli
