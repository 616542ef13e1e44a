// SPDX-License-Identifier: Apache-2.0
// Finds parameters that have no effect because the choice or object that they belong to is missing. Each rule of a
// table names parameters and what gives them a meaning; a given parameter without any of these is a fault.
#include "meristem/graph/table/meaning.h"

#include <algorithm>

#include <fmt/format.h>

#include "meristem/base/function_ref.h"

namespace meristem {

namespace {

using Meaning = ParameterTable::Meaning;

/// Splits a row path into its first name and the rest.
std::pair<std::string_view, std::string_view> first_of(std::string_view row_path) {
  const std::size_t dot = row_path.find('.');
  return {row_path.substr(0, dot), dot == std::string_view::npos ? std::string_view() : row_path.substr(dot + 1)};
}

/// Returns the member at a path, or null if there is none.
const Value* find_at(const Value& value, std::string_view row_path) {
  const auto [name, rest] = first_of(row_path);
  const Value* member = value.find(name);
  return member == nullptr || rest.empty() ? member : find_at(*member, rest);
}

/// Returns the present value of a parameter of the struct, as a document would write it.
Value present(const ParameterTable& table, const void* object, std::string_view row_path) {
  const auto [name, rest] = first_of(row_path);
  const Parameter* row = table.find(name);
  if (row == nullptr) return {};
  const Value shown = row->show(object);
  if (rest.empty()) return shown;
  const Value* member = find_at(shown, rest);
  return member == nullptr ? Value() : *member;
}

/// Calls `report` with the document path of a row path below `path`.
void at_path(const DocumentPath& path, std::string_view row_path, FunctionRef<void(const DocumentPath&)> report) {
  const auto [name, rest] = first_of(row_path);
  const DocumentPath here(path, name);
  if (rest.empty()) return report(here);
  at_path(here, rest, report);
}

std::string written(const Value& value) {
  if (const bool* boolean = value.boolean()) return *boolean ? "true" : "false";
  return fmt::format("\"{}\"", value.text() != nullptr ? *value.text() : value.description());
}

/// Returns the missing giver as text: "\"style\": \"tubes\"", or "'crown' beside it".
std::string request(const Meaning::Giver& giver) {
  if (giver.values.empty()) return fmt::format("'{}' beside it", giver.parameter);
  std::vector<std::string> values;
  for (const Value& value : giver.values) values.push_back(written(value));
  return fmt::format("\"{}\": {}", giver.parameter, fmt::join(values, " or "));
}

/// Returns the reason why nothing gives the parameter a meaning.
std::string lack(const Meaning& meaning, const ParameterTable& table, const void* object) {
  if (meaning.givers.empty()) return "here: " + meaning.reason;
  const Meaning::Giver& giver = meaning.givers.front();
  if (meaning.givers.size() > 1) return "here";
  if (giver.values.empty()) return fmt::format("without '{}'", giver.parameter);
  return fmt::format("where '{}' is {}", giver.parameter, written(present(table, object, giver.parameter)));
}

std::string requests(const Meaning& meaning) {
  if (meaning.givers.empty()) return "no such key";
  std::vector<std::string> texts;
  for (const Meaning::Giver& giver : meaning.givers) texts.push_back(request(giver));
  return fmt::format("{}, or no such key", fmt::join(texts, ", "));
}

}  // namespace

void check_meanings(const ParameterTable& table, const void* object, const Value& value, const DocumentPath& path,
                    ParameterReader& reader) {
  const auto gives = [&](const Meaning::Giver& giver) {
    if (giver.values.empty()) return find_at(value, giver.parameter) != nullptr;
    return std::ranges::find(giver.values, present(table, object, giver.parameter)) != giver.values.end();
  };
  for (const Meaning& meaning : table.meanings) {
    const auto is_given = [&](const std::string& row_path) { return find_at(value, row_path) != nullptr; };
    if (std::ranges::none_of(meaning.parameters, is_given)) continue;
    if (std::ranges::any_of(meaning.givers, gives)) continue;
    for (const std::string& row_path : meaning.parameters) {
      if (!is_given(row_path)) continue;
      at_path(path, row_path, [&](const DocumentPath& at) {
        reader.add_meaning_error(at, fmt::format("'{}' has no meaning {}", row_path, lack(meaning, table, object)),
                                 requests(meaning));
      });
    }
  }
}

}  // namespace meristem
