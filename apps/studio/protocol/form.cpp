// SPDX-License-Identifier: Apache-2.0
#include "protocol/form.h"

#include <algorithm>

namespace meristem::studio {

const Member* Record::find(std::string_view member) const {
  const auto own = std::ranges::find(members, member, &Member::name);
  if (own != members.end()) return &*own;
  for (const Part& part : parts) {
    if (const Member* found = part.record().find(member)) return found;
  }
  return nullptr;
}

std::vector<std::string> Record::names() const {
  std::vector<std::string> all;
  for (const Member& member : members) all.push_back(member.name);
  for (const Part& part : parts) {
    const std::vector<std::string> more = part.record().names();
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

namespace forms {

Form any() { return {.kind = Form::Kind::any}; }
Form flag() { return {.kind = Form::Kind::flag}; }
Form number(Span span) { return {.kind = Form::Kind::number, .span = span}; }
Form whole(Span span) { return {.kind = Form::Kind::whole, .span = span}; }
Form text() { return {.kind = Form::Kind::text}; }
Form choice(std::vector<std::string> names) { return {.kind = Form::Kind::choice, .names = std::move(names)}; }

Form list(Form element, std::size_t max_size, std::size_t min_size) {
  return {.kind = Form::Kind::list, .min_size = min_size, .max_size = max_size, .parts = {std::move(element)}};
}

Form tuple(const std::vector<std::pair<std::string, Form>>& parts) {
  Form form{.kind = Form::Kind::tuple};
  for (const auto& [name, part] : parts) {
    form.names.push_back(name);
    form.parts.push_back(part);
  }
  return form;
}

Form map(Form value, std::size_t max_size) {
  return {.kind = Form::Kind::map, .max_size = max_size, .parts = {std::move(value)}};
}

Form record(RecordFunction record) { return {.kind = Form::Kind::record, .records = {record}}; }

Form kinds(std::vector<RecordFunction> records) { return {.kind = Form::Kind::kinds, .records = std::move(records)}; }

Form or_null(Form form) {
  form.or_null = true;
  return form;
}

Form vector(Span span) { return tuple({{"x", number(span)}, {"y", number(span)}, {"z", number(span)}}); }

Form array() { return tuple({{"at", whole()}, {"count", whole()}}); }

}  // namespace forms

}  // namespace meristem::studio
