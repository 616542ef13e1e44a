// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/parameter.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace meristem {

std::string_view unit_name(Unit unit) {
  switch (unit) {
    case Unit::none:
      return "";
    case Unit::metre:
      return "m";
    case Unit::degree:
      return "°";
    case Unit::per_metre:
      return "per m";
    case Unit::per_cubic_metre:
      return "per m³";
    case Unit::second:
      return "s";
    case Unit::hour:
      return "h";
    case Unit::day:
      return "d";
    case Unit::step:
      return "steps";
  }
  return "";
}

namespace {

std::string range_text(const NumberForm& form) {
  const bool low = std::isfinite(form.min);
  const bool high = std::isfinite(form.max);
  const std::string_view from = form.above_min ? "above" : "from";
  if (low && high) return fmt::format(" {} {:.16g} to {:.16g}", from, form.min, form.max);
  if (low)
    return form.above_min ? fmt::format(" above {:.16g}", form.min) : fmt::format(" of at least {:.16g}", form.min);
  if (high) return fmt::format(" of at most {:.16g}", form.max);
  return "";
}

std::string number_text(std::string_view noun, const NumberForm& form) {
  std::string text(noun);
  if (form.unit != Unit::none) text += fmt::format(" ({})", unit_name(form.unit));
  return text + range_text(form);
}

}  // namespace

std::string Parameter::expectation() const {
  switch (kind) {
    case ParameterKind::number:
      return number_text("a number", form);
    case ParameterKind::integer:
      return number_text("a whole number", form);
    case ParameterKind::boolean:
      return "true or false";
    case ParameterKind::text:
      return "a text";
    case ParameterKind::lines:
      return "a text or a list of its lines";
    case ParameterKind::choice:
      return fmt::format("one of {}", fmt::join(choices, ", "));
    case ParameterKind::integers:
      return fmt::format("a list of {} whole numbers{}", count, range_text(form));
    case ParameterKind::vector:
      return "a list of three numbers [x, y, z]" + range_text(form);
    case ParameterKind::colour:
      return "a colour such as \"#6b8e23\"";
    case ParameterKind::colours:
      return "a list of colours such as [\"#6b8e23\", \"#d9a441\"]";
    case ParameterKind::curve:
      return "a curve such as {\"curve\": [[0, 1], [1, 0]]}";
    case ParameterKind::points:
      return "a list of pairs such as [[0, 1], [0.5, 2]]";
    case ParameterKind::places:
      return "a list of positions such as [[0, 0, 0], [3, 0, 0]]";
    case ParameterKind::condition:
      return fmt::format("a condition over {}", fmt::join(names, ", "));
    case ParameterKind::formula:
      return fmt::format("a number, or an expression over {}", fmt::join(names, ", "));
    case ParameterKind::selection:
      return "a list such as [0, [3, 5], \"i % 4 == 2\"]";
    case ParameterKind::box:
      return "two corners, the lower first, such as [[-1, 0, -1], [1, 2, 1]]";
    case ParameterKind::file:
      return "the path of a file";
    case ParameterKind::object:
      return fmt::format("an object with {}", fmt::join(nested().names(), ", "));
    case ParameterKind::list:
      return fmt::format("a list of objects with {}", fmt::join(nested().names(), ", "));
    case ParameterKind::map:
      return fmt::format("an object of names, each with {}", fmt::join(nested().names(), ", "));
  }
  return "";
}

const Parameter* ParameterTable::find(std::string_view parameter) const {
  for (const Parameter& row : parameters) {
    if (row.name == parameter) return &row;
  }
  return nullptr;
}

const std::string* ParameterTable::reason_without(std::string_view parameter) const {
  for (const Meaning& meaning : meanings) {
    const auto& names = meaning.parameters;
    if (meaning.givers.empty() && std::find(names.begin(), names.end(), parameter) != names.end()) {
      return &meaning.reason;
    }
  }
  return nullptr;
}

bool ParameterTable::contains_itself() const {
  std::vector<const ParameterTable*> reached{this};
  for (std::size_t k = 0; k < reached.size(); ++k) {
    for (const Parameter& row : reached[k]->parameters) {
      if (row.nested == nullptr) continue;
      const ParameterTable& below = row.nested();
      if (&below == this) return true;
      if (std::find(reached.begin(), reached.end(), &below) == reached.end()) reached.push_back(&below);
    }
  }
  return false;
}

std::vector<std::string> ParameterTable::names() const {
  std::vector<std::string> names = elsewhere;
  for (const Parameter& row : parameters) names.push_back(row.name);
  return names;
}

}  // namespace meristem
