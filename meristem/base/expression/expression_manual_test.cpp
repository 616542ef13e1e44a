// SPDX-License-Identifier: Apache-2.0
// Compares docs/manual/expressions.md with the implementation: every example must have the result in the manual, and
// every function and constant must be in the manual.
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/expression/expression.h"
#include "meristem/base/expression/expression_functions.h"

namespace meristem::expression_manual_test {

std::string manual() {
  std::ifstream file(MERISTEM_SOURCE_DIR "/docs/manual/expressions.md");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" `");
  if (first == std::string_view::npos) return "";
  return text.substr(first, text.find_last_not_of(" `") - first + 1);
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.emplace_back(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

double number(std::string_view text) {
  double value = std::nan("");
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

struct Example {
  std::string formula;
  ExpressionNames names;
  std::vector<double> values;
  double result = 0;
};

/// Returns the rows below the heading "Examples".
std::vector<Example> examples(const std::string& text) {
  std::vector<Example> result;
  std::istringstream lines(text.substr(text.find("## Examples")));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `")) continue;
    const auto cells = split(line, '|');
    Example& example = result.emplace_back();
    example.formula = cells.at(1);
    example.result = number(cells.at(3));
    for (const std::string& setting : split(cells.at(2), ',')) {
      if (setting.empty()) continue;
      const auto sides = split(setting, '=');
      example.names.variables.push_back(sides.at(0));
      example.values.push_back(number(sides.at(1)));
    }
  }
  return result;
}

TEST(ExpressionManual, EveryExampleHasItsResult) {
  const auto all = examples(manual());
  EXPECT_GE(all.size(), 40U);
  for (const Example& example : all) {
    const double value = Expression::compile(example.formula, example.names).evaluate(example.values);
    EXPECT_EQ(value, example.result) << example.formula;
  }
}

TEST(ExpressionManual, ListsEveryFunctionWithItsSignatureAndEveryConstant) {
  const std::string text = manual();
  for (const auto& function : expression_functions()) {
    EXPECT_NE(text.find("| `" + function.signature + "` |"), std::string::npos) << function.signature;
  }
  for (const auto& constant : expression_constants()) {
    EXPECT_NE(text.find('`' + constant.name + '`'), std::string::npos) << constant.name;
  }
}

}  // namespace meristem::expression_manual_test
