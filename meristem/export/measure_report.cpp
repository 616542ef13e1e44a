// SPDX-License-Identifier: Apache-2.0
// Prints measures as JSON values, text or Markdown. All forms use the table of rows in measure_rows.cpp.
#include "meristem/export/measure_report.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "meristem/base/visible_text.h"

namespace meristem {
namespace {

constexpr int kNameWidth = 24;  // width of the first column of the text, letters

Value as_value(std::monostate) { return {}; }
Value as_value(double number) { return number; }
Value as_value(std::uint64_t count) { return static_cast<double>(count); }

template <class Number>
Value as_value(const std::vector<Number>& numbers) {
  Value::List list;
  for (const Number number : numbers) list.push_back(as_value(number));
  return list;
}

bool shows(const MeasureReport& report, const MeasureRow& row) {
  return report.only.empty() || std::ranges::find(report.only, row.name) != report.only.end();
}

Value::Object as_object(const Measures& measures, std::span<const MeasureRow> rows, const MeasureReport& report) {
  Value::Object object;
  for (const MeasureRow& row : rows) {
    if (!shows(report, row)) continue;
    object.emplace_back(row.name, std::visit([](const auto& some) { return as_value(some); }, row.value(measures)));
  }
  return object;
}

std::string as_text(std::monostate) { return {}; }
std::string as_text(std::uint64_t count) { return std::to_string(count); }
std::string as_text(double number) {
  const bool is_long = std::abs(number) >= 1000 || number == std::floor(number);
  return is_long ? fmt::format("{:.0f}", number) : fmt::format("{:.4g}", number);
}

template <class Number>
std::string as_text(const std::vector<Number>& numbers) {
  std::string text;
  for (const Number number : numbers) text += (text.empty() ? "" : ", ") + as_text(number);
  return text;
}

std::string as_lines(const Measures& measures, std::span<const MeasureRow> rows, const MeasureReport& report) {
  std::string lines;
  for (const MeasureRow& row : rows) {
    if (!shows(report, row)) continue;
    const std::string value = std::visit([](const auto& some) { return as_text(some); }, row.value(measures));
    const bool has_unit = !value.empty() && !row.unit.empty();
    fmt::format_to(std::back_inserter(lines), "{:<{}} {}{}{}\n", row.name, kNameWidth, value.empty() ? "-" : value,
                   has_unit ? " " : "", has_unit ? row.unit : "");
  }
  return lines;
}

/// Returns the origin of a tree, with null for unknown parts.
Value::Object as_object(const TreeOrigin& origin) {
  Value::Object object;
  const bool is_known = !origin.component.empty();
  object.emplace_back("component", is_known ? Value(origin.component) : Value());
  object.emplace_back("instance", is_known ? Value(static_cast<double>(origin.instance)) : Value());
  object.emplace_back("row", origin.row == kNoRow ? Value() : Value(static_cast<double>(origin.row)));
  object.emplace_back("position", Value::List{origin.position.x, origin.position.y, origin.position.z});
  return object;
}

Value::List as_list(const LeafLayers& layers) {
  Value::List list;
  for (std::size_t k = 0; k < layers.area.size(); ++k) {
    list.emplace_back(Value::Object{{"low", layers.low(k)}, {"high", layers.high(k)}, {"leaf_area", layers.area[k]}});
  }
  return list;
}

/// Prints the layers from the highest to the lowest, as they stand.
std::string as_lines(const LeafLayers& layers) {
  std::string lines = "\nleaf area by height\n";
  for (std::size_t k = layers.area.size(); k-- > 0;) {
    const std::string name = fmt::format("{:.4g} to {:.4g} m", layers.low(k), layers.high(k));
    fmt::format_to(std::back_inserter(lines), "{:<{}} {} m²\n", name, kNameWidth, as_text(layers.area[k]));
  }
  return lines;
}

std::string heading_of(const TreeOrigin& origin, std::size_t number) {
  const Vec3 position = origin.position;
  const std::string standing = fmt::format("at {:.4g}, {:.4g}, {:.4g}", position.x, position.y, position.z);
  if (origin.component.empty()) return fmt::format("tree {}, {}", number, standing);
  const std::string row = origin.row == kNoRow ? "" : fmt::format("row {}, ", origin.row);
  return fmt::format("tree {}: {} {}, {}{}", number, visible_text(origin.component), origin.instance, row, standing);
}

}  // namespace

Value measures_value(const StandMeasures& measures, const MeasureReport& report) {
  Value::Object object = as_object(measures.whole, measure_rows(), report);
  if (measures.layers) object.emplace_back("layers", as_list(*measures.layers));
  if (report.each) {
    Value::List trees;
    for (std::size_t k = 0; k < measures.trees.size(); ++k) {
      Value::Object tree = as_object(measures.origins.at(k));
      for (auto& member : as_object(measures.trees[k], tree_measure_rows(), report)) tree.push_back(std::move(member));
      trees.emplace_back(std::move(tree));
    }
    object.emplace_back("each", std::move(trees));
  }
  return object;
}

std::string measures_text(const StandMeasures& measures, const MeasureReport& report) {
  std::string text = as_lines(measures.whole, measure_rows(), report);
  if (measures.layers) text += as_lines(*measures.layers);
  if (!report.each) return text;
  for (std::size_t k = 0; k < measures.trees.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "\n{}\n{}", heading_of(measures.origins.at(k), k + 1),
                   as_lines(measures.trees[k], tree_measure_rows(), report));
  }
  return text;
}

std::string measures_reference() {
  std::string text = "| measure | unit | meaning |\n| --- | --- | --- |\n";
  for (const MeasureRow& row : measure_rows()) {
    fmt::format_to(std::back_inserter(text), "| `{}` | {} | {} |\n", row.name, row.unit, row.doc);
  }
  return text;
}

}  // namespace meristem
