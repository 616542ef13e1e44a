// SPDX-License-Identifier: Apache-2.0
// Rows and tables of parameters: their words in messages, their defaults, and the rules between parameters. Structs are
// reached by byte offsets and by the functions of their member types, so one implementation serves all tables.
#include "meristem/graph/table/parameter.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "meristem/graph/table/kinds.h"

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

std::string_view in_space_name(InSpace what) {
  switch (what) {
    case InSpace::none:
      return "";
    case InSpace::position:
      return "position";
    case InSpace::shift:
      return "shift";
    case InSpace::turn:
      return "turn";
    case InSpace::direction:
      return "direction";
    case InSpace::radii:
      return "radii";
    case InSpace::radius:
      return "radius";
    case InSpace::height:
      return "height";
    case InSpace::width:
      return "width";
    case InSpace::profile:
      return "profile";
  }
  return "";
}

std::string_view points_form_name(PointsForm form) {
  switch (form) {
    case PointsForm::line:
      return "line";
    case PointsForm::polygon:
      return "polygon";
    case PointsForm::silhouette:
      return "silhouette";
    case PointsForm::apart:
      return "apart";
  }
  return "";
}

std::string_view kind_name(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::number:
      return "number";
    case ParameterKind::integer:
      return "integer";
    case ParameterKind::boolean:
      return "boolean";
    case ParameterKind::text:
      return "text";
    case ParameterKind::lines:
      return "lines";
    case ParameterKind::choice:
      return "choice";
    case ParameterKind::integers:
      return "integers";
    case ParameterKind::vector:
      return "vector";
    case ParameterKind::facing:
      return "facing";
    case ParameterKind::colour:
      return "colour";
    case ParameterKind::colours:
      return "colours";
    case ParameterKind::curve:
      return "curve";
    case ParameterKind::points:
      return "points";
    case ParameterKind::positions:
      return "positions";
    case ParameterKind::condition:
      return "condition";
    case ParameterKind::formula:
      return "formula";
    case ParameterKind::selection:
      return "selection";
    case ParameterKind::box:
      return "box";
    case ParameterKind::file:
      return "file";
    case ParameterKind::object:
      return "object";
    case ParameterKind::list:
      return "list";
    case ParameterKind::map:
      return "map";
  }
  return "";
}

namespace {

std::string range_text(const NumberRange& form) {
  const bool low = std::isfinite(form.min);
  const bool high = std::isfinite(form.max);
  const std::string_view from = form.above_min ? "above" : "from";
  if (low && high) return fmt::format(" {} {:.16g} to {:.16g}", from, form.min, form.max);
  if (low)
    return form.above_min ? fmt::format(" above {:.16g}", form.min) : fmt::format(" of at least {:.16g}", form.min);
  if (high) return fmt::format(" of at most {:.16g}", form.max);
  return "";
}

std::string number_text(std::string_view noun, const NumberRange& form) {
  std::string text(noun);
  if (form.unit != Unit::none) text += fmt::format(" ({})", unit_name(form.unit));
  return text + range_text(form);
}

}  // namespace

bool Parameter::may_vary() const {
  const bool is_number = kind == ParameterKind::number || kind == ParameterKind::integer ||
                         kind == ParameterKind::vector || kind == ParameterKind::box;
  return is_number && !form.fixed;
}

KeyClock Parameter::key_clock(bool in_component) const {
  if (form.timeless) return KeyClock::none;
  if (in_component && may_vary() && kind != ParameterKind::box) return KeyClock::instance;
  switch (kind) {
    case ParameterKind::number:
    case ParameterKind::integer:
    case ParameterKind::vector:
    case ParameterKind::colour:
    case ParameterKind::boolean:
    case ParameterKind::choice:
    case ParameterKind::curve:
    case ParameterKind::points:
    case ParameterKind::positions:
      return KeyClock::document;
    default:
      return KeyClock::none;
  }
}

bool Parameter::has_values_between() const {
  return kind == ParameterKind::number || kind == ParameterKind::integer || kind == ParameterKind::vector ||
         kind == ParameterKind::colour || kind == ParameterKind::curve || kind == ParameterKind::points ||
         kind == ParameterKind::positions;
}

std::string Parameter::expectation() const {
  switch (kind) {
    case ParameterKind::number:
      return number_text("a number", form);
    case ParameterKind::integer:
      return number_text(form.counts ? "a number" : "a whole number", form);
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
    case ParameterKind::facing:
      return "a direction [x, y, z], or \"surface\"";
    case ParameterKind::colour:
      return "a colour such as \"#6b8e23\"";
    case ParameterKind::colours:
      return "a list of colours such as [\"#6b8e23\", \"#d9a441\"]";
    case ParameterKind::curve:
      return "a curve such as {\"curve\": [[0, 1], [1, 0]]}";
    case ParameterKind::points:
      if (!second) return "a list of pairs such as [[0, 1], [0.5, 2]]";
      return fmt::format("a list of pairs of a number{} and a number{}", range_text(form), range_text(*second));
    case ParameterKind::positions:
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

void Parameter::read(void* object, const Value& value, const DocumentPath& path, ParameterReader& reader) const {
  type->read(*this, static_cast<std::byte*>(object) + offset, value, path, reader);
}

Value Parameter::show(const void* object) const {
  return type->show(*this, static_cast<const std::byte*>(object) + offset);
}

Value Parameter::fallback() const { return original != nullptr ? show(original.get()) : Value(); }

const ParameterTable& Parameter::table_of(const void* member, std::size_t index) const {
  return kinds == nullptr ? nested() : kinds().kinds[type->kind(member, index)].table();
}

Parameter& ParameterTable::add(ParameterKind kind, std::string_view row_name, std::string_view row_doc,
                               std::size_t offset, const MemberType& type) {
  Parameter& row = parameters.emplace_back();
  row.name = row_name;
  row.doc = row_doc;
  row.kind = kind;
  row.offset = offset;
  row.type = &type;
  row.original = original;
  return row;
}

void ParameterTable::add_rows(const ParameterTable& table, std::size_t offset) {
  for (const Parameter& theirs : table.parameters) {
    Parameter& ours = parameters.emplace_back(theirs);
    ours.offset += offset;
    ours.original = original;
  }
  one_of.insert(one_of.end(), table.one_of.begin(), table.one_of.end());
  company.insert(company.end(), table.company.begin(), table.company.end());
  meanings.insert(meanings.end(), table.meanings.begin(), table.meanings.end());
}

void ParameterTable::leave_out(std::vector<std::string> rows, std::string reason) {
  const auto is_out = [&rows](const std::string& row) {
    return std::find(rows.begin(), rows.end(), row) != rows.end();
  };
  std::erase_if(parameters, [&](const Parameter& row) { return is_out(row.name); });
  std::erase_if(company, [&](const Company& rule) { return is_out(rule.parameter) || is_out(rule.other); });
  meanings.push_back({std::move(rows), {}, std::move(reason)});
}

std::vector<Value> ParameterTable::defaults() const {
  std::vector<Value> values;
  values.reserve(parameters.size());
  for (const Parameter& row : parameters) values.push_back(row.fallback());
  return values;
}

Value ParameterTable::show(const void* object) const {
  Value::Object members;
  for (const Parameter& row : parameters) {
    Value shown = row.show(object);
    if (!shown.is_null()) members.emplace_back(row.name, std::move(shown));
  }
  return members;
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

void ParameterTable::check_all(const void* object, const DocumentPath& path, ParameterReader& reader) const {
  if (check) check(object, path, reader);
  for (const Parameter& row : parameters) {
    if (row.nested == nullptr) continue;
    const DocumentPath row_place(path, row.name);
    // The function gives elements only by a pointer that could change them; nothing changes here.
    void* member = const_cast<std::byte*>(static_cast<const std::byte*>(object) + row.offset);
    for (std::size_t k = 0; k < row.type->count(member); ++k) {
      const DocumentPath element_place = row.kind == ParameterKind::map
                                             ? DocumentPath(row_place, row.type->name(member, k))
                                             : DocumentPath(row_place, k);
      row.table_of(member, k).check_all(row.type->element(member, k),
                                        row.kind == ParameterKind::object ? row_place : element_place, reader);
    }
  }
}

bool GivenRows::contains(std::string_view row) const {
  return std::any_of(rows_.begin(), rows_.end(), [row](const Parameter* given) { return given->name == row; });
}

void GivenRows::copy(const void* from, void* to) const {
  for (const Parameter* row : rows_) {
    row->type->copy(static_cast<std::byte*>(to) + row->offset, static_cast<const std::byte*>(from) + row->offset);
  }
}

}  // namespace meristem
