// SPDX-License-Identifier: Apache-2.0
// Follows a path through the tree of a document and the tables of its parameters at the same time. A bare value where a
// table has an object is replaced by that object.
#include "meristem/document/short_forms.h"

#include <charconv>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "meristem/document/tables.h"
#include "meristem/graph/crown_placement.h"
#include "meristem/graph/placement.h"

namespace meristem {

namespace {

/// Returns the element of a list that `text`, for example "[2]", names. Returns null if it does not exist.
Value* element_of(Value& at, const std::string& text) {
  if (at.list() == nullptr || text.size() < 3 || text[0] != '[') return nullptr;
  std::size_t index = 0;
  const char* const end = text.data() + text.size() - 1;
  const auto parsed = std::from_chars(text.data() + 1, end, index);
  if (parsed.ec != std::errc() || parsed.ptr != end || index >= at.list()->size()) return nullptr;
  return &(*at.list())[index];
}

/// Follows the rest of a path below the value of an object with this table.
void follow(const ParameterTable* table, Value* at, std::span<const std::string> rest) {
  while (!rest.empty() && rest[0][0] != '[') {
    if (at->object() == nullptr) {
      if (at->is_null() || table->shorthand.empty()) return;
      *at = Value(Value::Object{{table->shorthand, std::move(*at)}});
    }
    const Parameter* row = table->find(rest[0]);
    Value* next = at->find(rest[0]);
    if (row == nullptr || row->nested == nullptr || next == nullptr) return;
    rest = rest.subspan(1);
    const bool is_list = row->kind == ParameterKind::list, is_map = row->kind == ParameterKind::map;
    if (is_list || is_map) {
      if (rest.empty()) return;
      next = is_list ? element_of(*next, rest[0]) : next->find(rest[0]);
      if (next == nullptr) return;
      rest = rest.subspan(1);
    }
    table = &row->nested();
    at = next;
  }
}

const ParameterTable* table_of_component(const Value& component, const Registry& registry) {
  const Value* name = component.find("type");
  const ComponentType* type = name == nullptr || name->text() == nullptr ? nullptr : registry.find(*name->text());
  return type == nullptr ? nullptr : &type->parameters;
}

}  // namespace

void write_out_short_forms(Value& root, const Registry& registry, const std::vector<std::string>& elements) {
  if (elements.size() < 3) return;
  const std::span rest = std::span(elements).subspan(2);
  Value* const top = root.find(elements[0]);
  if (top == nullptr) return;
  if (elements[0] == "components") {
    Value* component = top->find(elements[1]);
    const ParameterTable* table = component == nullptr ? nullptr : table_of_component(*component, registry);
    if (table != nullptr) follow(table, component, rest);
  } else if (elements[0] == "variables") {
    if (Value* variable = top->find(elements[1])) follow(&variable_table(), variable, rest);
  } else if (elements[0] == "links") {
    Value* link = element_of(*top, elements[1]);
    const Value* kind = link == nullptr ? nullptr : link->find("kind");
    const bool is_crown = kind != nullptr && *kind == Value("crown");
    if (link != nullptr) follow(is_crown ? &crown_placement_table() : &placement_table(), link, rest);
  } else {
    follow(&head_table(), &root, elements);
  }
}

}  // namespace meristem
