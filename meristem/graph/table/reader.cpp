// SPDX-License-Identifier: Apache-2.0
// Reads objects into structs: each member by its row, then the rules between rows. Unknown members are reported with
// the nearest known name.
#include "meristem/graph/table/reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "meristem/graph/table/meaning.h"

namespace meristem {

ParameterReader::ParameterReader(std::vector<ExpressionNames::Constant> constants, const SizeLimits& limits,
                                 FileAccess access)
    : ReadErrors(limits),
      expressions_(std::move(constants), *this),
      files_(std::move(access), *this),
      numbers_(expressions_, files_, *this) {}

std::vector<Varying> ParameterReader::read_varying(const ParameterTable& table, void* object, const Value& value,
                                                   const DocumentPath& path) {
  numbers_.begin_component(object);
  this->object(table, object, value, path);
  return numbers_.end_component();
}

void ParameterReader::element(const Parameter& row, void* member, std::size_t index, const Value& value,
                              const DocumentPath& path) {
  void* const element = row.type->element(member, index);
  const ParameterTable& table = row.table_of(member, index);
  const NumberReader::InElement inside(numbers_, member, row.type, index, element);
  object(table, element, value, path);
}

GivenRows ParameterReader::read(const ParameterTable& table, void* object, const Value& value,
                                const DocumentPath& path) {
  return this->object(table, object, value, path);
}

GivenRows ParameterReader::object(const ParameterTable& table, void* object, const Value& value,
                                  const DocumentPath& path) {
  check_stop();
  GivenRows given;
  const std::size_t errors_before = error_count();
  const auto finish = [&] {
    if (table.check && error_count() == errors_before) table.check(object, path, *this);
    if (table.prepare && error_count() == errors_before) table.prepare(object, path, *this);
  };
  const Value::Object* members = value.object();
  if (members == nullptr) {
    if (const Parameter* bare = table.shorthand.empty() ? nullptr : table.find(table.shorthand)) {
      given.add(*bare);
      bare->read(object, value, path, *this);
      finish();
    } else {
      add_error(path, fmt::format("{} cannot be {}", table.name, value.description()),
                fmt::format("an object with {}", fmt::join(table.names(), ", ")));
    }
    return given;
  }

  // Each member is read by its row. An unknown member is reported with the nearest known name.
  for (const auto& [name, member] : *members) {
    const DocumentPath member_place(path, name);
    const Parameter* row = table.find(name);
    if (row == nullptr && std::ranges::find(table.elsewhere, name) != table.elsewhere.end()) continue;
    if (const std::string* reason = row == nullptr ? table.reason_without(name) : nullptr) {
      add_name_error(member_place, fmt::format("'{}' has no meaning here: {}", name, *reason), "no such key", "");
      continue;
    }
    if (row == nullptr) {
      const std::vector<std::string> names = table.names();
      const std::string similar = nearest(name, names);
      add_name_error(member_place, fmt::format("'{}' is not a parameter of {}", name, table.name),
                     similar.empty() ? fmt::format("one of {}", fmt::join(names, ", ")) : "", similar);
      continue;
    }
    given.add(*row);
    row->read(object, member, member_place, *this);
  }

  check_given(table, given, path);
  if (error_count() == errors_before) check_meanings(table, object, value, path, *this);
  finish();
  return given;
}

/// Reports missing required rows, and rows that exclude each other.
void ParameterReader::check_given(const ParameterTable& table, const GivenRows& given, const DocumentPath& path) {
  for (const Parameter& row : table.parameters) {
    if (row.required && !given.contains(row.name)) {
      add_error(path, fmt::format("{} has no '{}'", table.name, row.name), row.expectation());
    }
  }
  for (const std::vector<std::string>& group : table.one_of) {
    const auto count =
        std::count_if(group.begin(), group.end(), [&](const auto& name) { return given.contains(name); });
    if (count != 1) {
      add_error(
          path,
          fmt::format("{} has {} of {}", table.name, count == 0 ? "none" : "more than one", fmt::join(group, ", ")),
          "exactly one of them");
    }
  }
  for (const ParameterTable::Company& rule : table.company) {
    if (!given.contains(rule.parameter) || given.contains(rule.other) == rule.is_wanted) continue;
    const DocumentPath other(path, rule.other);
    add_meaning_error(
        DocumentPath(path, rule.parameter),
        fmt::format("'{}' has no meaning {} '{}'", rule.parameter, rule.is_wanted ? "without" : "beside", rule.other),
        rule.is_wanted ? fmt::format("'{}' beside it", rule.other) : "only one of them",
        rule.is_wanted ? nullptr : &other);
  }
}

const std::string* ParameterReader::text(const Parameter& parameter, const Value& value, const DocumentPath& path) {
  if (value.text() == nullptr) wrong_kind(parameter, value, path);
  return value.text();
}

std::optional<std::size_t> ParameterReader::choice(const Parameter& parameter, const Value& value,
                                                   const DocumentPath& path) {
  const std::string* given = text(parameter, value, path);
  if (given == nullptr) return std::nullopt;
  const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), *given);
  if (found != parameter.choices.end()) return static_cast<std::size_t>(found - parameter.choices.begin());
  add_error(path, fmt::format("'{}' is not a value of '{}'", *given, parameter.name), parameter.expectation(),
            nearest(*given, parameter.choices));
  return std::nullopt;
}

}  // namespace meristem
