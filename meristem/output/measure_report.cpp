// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/measure_report.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace meristem {
namespace {

constexpr int kNameWidth = 24;  // of the text's first column

enum class Subject { whole, tree };

bool is_shown(const MeasureRow& row, Subject subject) { return subject == Subject::whole || !row.only_whole; }

Value as_value(const MeasureValue& measured) {
  if (const double* number = std::get_if<double>(&measured)) return *number;
  if (const auto* numbers = std::get_if<std::vector<double>>(&measured)) {
    return Value::List(numbers->begin(), numbers->end());
  }
  return {};
}

Value::Object as_object(const Measures& measures, Subject subject) {
  Value::Object object;
  for (const MeasureRow& row : measure_rows()) {
    if (is_shown(row, subject)) object.emplace_back(row.name, as_value(row.value(measures)));
  }
  return object;
}

std::string as_text(double number) {
  const bool is_long = std::abs(number) >= 1000 || number == std::floor(number);
  return is_long ? fmt::format("{:.0f}", number) : fmt::format("{:.4g}", number);
}

std::string as_text(const MeasureValue& measured) {
  if (const double* number = std::get_if<double>(&measured)) return as_text(*number);
  std::string text;
  if (const auto* numbers = std::get_if<std::vector<double>>(&measured)) {
    for (const double number : *numbers) text += (text.empty() ? "" : ", ") + as_text(number);
  }
  return text;
}

std::string as_lines(const Measures& measures, Subject subject) {
  std::string lines;
  for (const MeasureRow& row : measure_rows()) {
    if (!is_shown(row, subject)) continue;
    const std::string value = as_text(row.value(measures));
    const bool has_unit = !value.empty() && !row.unit.empty();
    fmt::format_to(std::back_inserter(lines), "{:<{}} {}{}{}\n", row.name, kNameWidth, value.empty() ? "-" : value,
                   has_unit ? " " : "", has_unit ? row.unit : "");
  }
  return lines;
}

}  // namespace

Value measures_value(const StandMeasures& measures, bool each) {
  Value::Object object = as_object(measures.whole, Subject::whole);
  if (each) {
    Value::List trees;
    for (const Measures& tree : measures.trees) trees.emplace_back(as_object(tree, Subject::tree));
    object.emplace_back("each", std::move(trees));
  }
  return object;
}

std::string measures_text(const StandMeasures& measures, bool each) {
  std::string text = as_lines(measures.whole, Subject::whole);
  if (!each) return text;
  for (std::size_t k = 0; k < measures.trees.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "\ntree {}\n{}", k + 1, as_lines(measures.trees[k], Subject::tree));
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
