// SPDX-License-Identifier: Apache-2.0
// Checks a value from the top down and stops at its first fault. Paths cost nothing until a fault is reported.
#include "protocol/check.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/in_quotes.h"
#include "meristem/base/visible_text.h"
#include "refusal.h"

namespace meristem::studio {

namespace {

constexpr std::size_t kLongestText = 120;  // bytes; keys of maps can be long, and only then a path is longer

std::string quoted(const DocumentPath& path) {
  const std::string text = path.text();
  if (text.empty()) return "the message";
  return text.size() > kLongestText ? in_quotes(text) : fmt::format("'{}'", visible_text(text));
}

[[noreturn]] void refuse(const DocumentPath& path, const std::string& what) { throw Refusal(quoted(path) + what); }

std::string joined(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

std::string span_text(const Span& span) {
  std::string text;
  if (std::isfinite(span.min)) text += fmt::format(" from {}", span.min);
  if (std::isfinite(span.max)) text += fmt::format(" {} {}", text.empty() ? "up to" : "to", span.max);
  if (span.unit != Unit::none) text += fmt::format(" ({})", unit_name(span.unit));
  return text;
}

bool is_given(const Value* member) { return member != nullptr && !member->is_null(); }

bool holds_number(const Form& form, const Value& value) {
  const double* number = value.number();
  return number != nullptr && std::isfinite(*number) && *number >= form.span.min && *number <= form.span.max;
}

void check_size(const Form& form, std::size_t size, const DocumentPath& path) {
  if (size > form.max_size) refuse(path, fmt::format(" has more than {} parts", form.max_size));
  if (size < form.min_size) refuse(path, fmt::format(" has fewer than {} parts", form.min_size));
}

void check_choice(const Form& form, const Value& value, const DocumentPath& path) {
  const std::string* text = value.text();
  if (text != nullptr && std::ranges::find(form.names, *text) != form.names.end()) return;
  refuse(path, fmt::format(" is none of {}{}", joined(form.names), text != nullptr ? similar(*text, form.names) : ""));
}

void check_kinds(const Form& form, const Value& value, const DocumentPath& path) {
  if (value.object() == nullptr) refuse(path, " is not an object");
  std::vector<std::string> names;
  for (const RecordFunction record : form.records) {
    const std::string& name = record().members[0].name;
    if (is_given(value.find(name))) return check_record(record(), value, path);
    names.push_back(name);
  }
  const Value::Object& given = *value.object();
  refuse(path, fmt::format(" has none of {}{}", joined(names), given.empty() ? "" : similar(given[0].first, names)));
}

/// Checks members against a record and its parts. A part may be missing as a whole.
void check_members(const Record& record, const Value& object, const DocumentPath& path, bool may_be_missing) {
  const auto is_there = [&](const std::string& name) { return object.find(name) != nullptr; };
  const auto& members = record.members;
  if (may_be_missing && std::ranges::none_of(members, is_there, &Member::name)) return;
  const Value* alone = record.alone ? object.find(record.alone->first) : nullptr;
  const bool is_alone = alone != nullptr && *alone == record.alone->second;
  for (const Member& member : members) {
    const Value* value = object.find(member.name);
    const bool is_other = is_alone && member.name != record.alone->first;
    if (is_other && value != nullptr)
      refuse(path, fmt::format(" has '{}' beside '{}'", member.name, record.alone->first));
    if (value == nullptr && member.is_required && !is_other) refuse(path, fmt::format(" has no '{}'", member.name));
    if (value != nullptr) check_form(member.form, *value, DocumentPath(path, member.name));
  }
  for (const std::vector<std::string>& group : record.one_of) {
    const auto count =
        std::ranges::count_if(group, [&](const std::string& name) { return is_given(object.find(name)); });
    if (count != 1) refuse(path, fmt::format(" needs exactly one of {}", joined(group)));
  }
  for (const Record::Part& part : record.parts) check_members(part.record(), object, path, part.is_optional);
}

}  // namespace

std::string similar(std::string_view name, std::span<const std::string> candidates) {
  const std::string nearest = nearest_name(name, candidates);
  return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

std::string expectation(const Form& form) {
  switch (form.kind) {
    case Form::Kind::any:
      return "a value";
    case Form::Kind::flag:
      return "true or false";
    case Form::Kind::number:
      return "a number" + span_text(form.span);
    case Form::Kind::whole:
      return "a whole number" + span_text(form.span);
    case Form::Kind::text:
      return "a text";
    case Form::Kind::choice:
      return "one of " + joined(form.names);
    case Form::Kind::list:
      return "a list";
    case Form::Kind::tuple:
      return fmt::format("a list [{}]", joined(form.names));
    case Form::Kind::map:
    case Form::Kind::record:
    case Form::Kind::kinds:
      return "an object";
  }
  return "";
}

void check_form(const Form& form, const Value& value, const DocumentPath& path) {
  if (form.or_null && value.is_null()) return;
  const auto require = [&](bool holds) {
    if (!holds) refuse(path, " is not " + expectation(form));
  };
  switch (form.kind) {
    case Form::Kind::any:
      return;
    case Form::Kind::flag:
      return require(value.boolean() != nullptr);
    case Form::Kind::number:
      return require(holds_number(form, value));
    case Form::Kind::whole:
      return require(holds_number(form, value) && *value.number() == std::floor(*value.number()));
    case Form::Kind::text:
      return require(value.text() != nullptr);
    case Form::Kind::choice:
      return check_choice(form, value, path);
    case Form::Kind::list:
    case Form::Kind::tuple: {
      const bool is_tuple = form.kind == Form::Kind::tuple;
      require(value.list() != nullptr && (!is_tuple || value.list()->size() == form.parts.size()));
      if (!is_tuple) check_size(form, value.list()->size(), path);
      for (std::size_t k = 0; k < value.list()->size(); ++k)
        check_form(form.parts[is_tuple ? k : 0], (*value.list())[k], DocumentPath(path, k));
      return;
    }
    case Form::Kind::map:
      require(value.object() != nullptr);
      check_size(form, value.object()->size(), path);
      for (const auto& [name, part] : *value.object()) check_form(form.parts[0], part, DocumentPath(path, name));
      return;
    case Form::Kind::record:
      require(value.object() != nullptr);
      return check_record(form.records[0](), value, path);
    case Form::Kind::kinds:
      return check_kinds(form, value, path);
  }
}

void check_record(const Record& record, const Value& object, const DocumentPath& path,
                  std::span<const std::string> others) {
  if (object.object() == nullptr) refuse(path, " is not an object");
  for (const auto& [name, value] : *object.object()) {
    if (record.find(name) != nullptr || std::ranges::find(others, name) != others.end()) continue;
    const std::vector<std::string> names = record.names();
    const std::string nearest = similar(name, names);
    const std::string known = names.empty() ? "; there are no members" : "; the members are " + joined(names);
    refuse(path, fmt::format(" has an unknown member {}{}", in_quotes(name), nearest.empty() ? known : nearest));
  }
  check_members(record, object, path, false);
}

void store_record(const Record& record, void* target, const Value& object, const DocumentPath& path) {
  for (const Member& member : record.members) {
    const Value* value = object.find(member.name);
    const bool takes_null = member.form.kind == Form::Kind::any && member.is_required;
    if (value != nullptr && (takes_null || !value->is_null()))
      member.store(target, *value, DocumentPath(path, member.name));
  }
  if (!record.rule) return;
  const std::string wrong = record.rule(target, object);
  if (!wrong.empty()) refuse(path, " " + wrong);
}

std::size_t kind_index(const Form& form, const Value& object) {
  const auto found = std::ranges::find_if(
      form.records, [&](const RecordFunction record) { return is_given(object.find(record().members[0].name)); });
  return static_cast<std::size_t>(found - form.records.begin());
}

}  // namespace meristem::studio
