// SPDX-License-Identifier: Apache-2.0
#include "tests/rows/other_values.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "meristem/document/json.h"

namespace meristem {

namespace {

/// JSON values by the names of parameters. Paths are relative to the folder of the documents.
const std::map<std::string, std::vector<std::string>>& values_by_name() {
  static const std::map<std::string, std::vector<std::string>> values = {
      {"a grassleaf.midrib_points", {"[[0, 0], [0.4, 0.5], [1.3, 0.3]]"}},
      {"an lsystem.grammar", {R"("#axiom\nF(0.4) +(30) F")"}},
      {"an operation.shoots",
       {R"("leader")", R"("rank == 2")", R"("main.2")", R"("main.3")", R"("main.4")", R"("main.5")", R"("main.7")"}},
      {"an operation.do", {}},
      {"an operation.above_lateral", {"1", "3"}},
      {"an operation.anchor", {R"("leader")", R"("rank == 0")"}},
      {"an operation.named", {R"("other")"}},
      {"an operation.state", {R"("spare")"}},
      {"an operation.when", {R"("height < 0")", R"("height > 0")"}},
      {"a placed document.file", {R"("placed/other.json")"}},
      {"places.choose", {R"("sort")"}},
      {"an area.polygon", {"[[0, 0], [4, 0], [4, 5]]"}},
      {"a line.points", {"[[0, 0], [0, 9]]"}},
      {"MTG features.x", {R"("AA")"}},
      {"MTG features.y", {R"("AA")"}},
      {"MTG features.z", {R"("AA")"}},
      {"MTG features.diameter", {R"("Thick")"}},
      {"a name.component", {R"("box")"}},
      {"a set value.value", {"2"}},
      {"a cloud.of", {R"("other")"}},
      {"a sun.date", {R"("2026-08-03")"}},
      {"an obstacle.name", {R"("wall")"}},
      {"a resource model.lambda_curve", {R"({"curve": [[0, 1], [1, 0.9]]})"}},
      {"an ffd.dx", {R"("x + 0.7*y")"}},
      {"an ffd.dy", {R"("y + 0.2*x")"}},
      {"an ffd.dz", {R"("z + 0.4*y")"}},
      {"a hyperpatch.dx", {R"("x + 0.7*y")"}},
      {"a hyperpatch.dy", {R"("y + 0.2*x")"}},
      {"a hyperpatch.dz", {R"("z + 0.4*y")"}},
      {"a control point.at",
       {"[-0.4, 0.1, -0.4]", "[0.4, 0.1, -0.4]", "[-0.4, 0.1, 0.4]", "[0.4, 0.1, 0.4]", "[-0.4, 1.2, -0.4]",
        "[0.6, 1.2, -0.4]", "[-0.4, 1.2, 0.4]", "[0.7, 1.2, 0.4]"}},
      {"a leaf.polygon", {"[[0.4, 0.2], [1, 0.5], [0.3, 0.8]]"}},
      {"a leaf.profile", {R"({"curve": [[0, 0], [1, 0.5]]})"}},
      {"a revolution.silhouette", {"[[0, 0], [0.05, 0.03], [0, 0.1]]"}},
      {"a surface.turn", {"90"}},
      {"a horn.outline", {"[[-1, -1], [1, -1], [0, 2]]"}},
      {"a simple.outline", {"[[-0.1, -0.1], [0.1, -0.1], [0, 0.2]]", "[[-0.1, 0], [0, 0.05], [0.1, 0]]"}},
  };
  return values;
}

/// Returns files in the folder of the documents, by the names of parameters.
std::vector<std::string> files_of(const std::string& row) {
  if (row == "mesh") return {R"("other_tetrahedron.obj")", R"("tetrahedron.obj")"};
  if (row == "file")
    return {R"("other_points.txt")", R"("points.txt")", R"("other_grammar.txt")", R"("other_tree.csv")"};
  if (row == "midrib") return {R"("other_midribs.csv")"};
  if (row == "table") return {R"("other_places.csv")"};
  if (row == "widths") return {R"("other_widths.csv")"};
  return {R"("../fuzz/corpus/image/rgb.png")"};
}

double number_of(const Value& value) { return value.number() != nullptr ? *value.number() : 0; }

std::vector<double> other_numbers(const Parameter& row, double present) {
  const NumberRange& form = row.form;
  const double low = std::max(form.min, -1e3);
  const double high = std::min(form.max, 1e3);
  std::vector<double> numbers = {
      1.4 * present, 0.6 * present, present + 0.3, present + 1, 0.5 * (low + high), 0.1, 1, 2, 3, 8, 12, 30, low, high};
  if (row.kind == ParameterKind::integer || row.kind == ParameterKind::integers) {
    for (double& number : numbers) number = std::round(number);
  }
  std::erase_if(numbers, [&](double number) {
    return number == present || number < form.min || number > form.max || (form.above_min && number == form.min);
  });
  return numbers;
}

std::vector<std::string> texts_of(const Parameter& row) {
  switch (row.kind) {
    case ParameterKind::colour:
      return {R"("#123456")"};
    case ParameterKind::colours:
      return {R"(["#123456", "#c0a080"])"};
    case ParameterKind::curve:
      return {R"({"curve": [[0, 0.4], [1, 0.8]]})", R"({"curve": [[0, 0], [0.5, 1], [1, 0.1]]})"};
    case ParameterKind::points:
      return {"[[0.2, 0.1], [0.5, 0.6], [0.1, 1.2]]"};
    case ParameterKind::positions:
      return {"[[0.3, 0, 0.1]]", "[[0, 0, 0], [1, 0, 0]]"};
    case ParameterKind::selection:
      return {"[0]"};
    case ParameterKind::box:
      return {"[[-0.5, 0.4, -0.5], [0.4, 1.3, 0.6]]", "[[-0.1, 0.5, -0.2], [0.2, 1, 0.2]]", "[[2, 0, 2], [3, 1, 4]]"};
    case ParameterKind::facing:
      return {"[0.3, 0.2, 0.9]", R"("surface")"};
    case ParameterKind::condition:
      return {R"("height > 0.5")", R"("u > 0.5")"};
    case ParameterKind::file:
      return files_of(row.name);
    case ParameterKind::formula:
      return {"0.5", "2"};
    case ParameterKind::integers:
      return {"[100, 200]", "[3, 1]"};
    case ParameterKind::vector:
      return {"[0.1, 0.2, 0.3]", "[1.5, 1.2, 0.7]", "[2, 3, 4]", "[30, 20, 10]"};
    default:
      return {};
  }
}

}  // namespace

std::vector<Value> other_values(const std::string& name, const Parameter& row, const Value& present) {
  std::vector<Value> values;
  if (row.name == "only") return {parse_json("[1]")};  // then the first instance has no geometry
  const auto known = values_by_name().find(name);
  for (const std::string& text : known == values_by_name().end() ? texts_of(row) : known->second) {
    values.push_back(parse_json(text));
  }
  if (row.kind == ParameterKind::number || row.kind == ParameterKind::integer) {
    for (const double number : other_numbers(row, number_of(present))) values.emplace_back(number);
  }
  if (row.kind == ParameterKind::boolean) values.emplace_back(present != Value(true));
  for (const std::string& choice : row.choices) values.emplace_back(choice);
  std::erase(values, present);
  return values;
}

}  // namespace meristem
