// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/kinds.h"

#include <algorithm>

#include <fmt/format.h>

#include "meristem/graph/table/reader.h"
#include "meristem/graph/table/table.h"

namespace meristem {

namespace {

bool is_required(const Kinds& kinds, const std::string& row) {
  return std::all_of(kinds.kinds.begin(), kinds.kinds.end(), [&](const Kinds::Kind& kind) {
    const Parameter* const own = kind.table().find(row);
    return own != nullptr && own->required;
  });
}

}  // namespace

ParameterTable table_of_kinds(const Kinds& kinds) {
  ParameterTable all;
  all.name = kinds.element;
  all.doc = kinds.doc;
  Parameter& says = all.parameters.emplace_back();
  says.name = kinds.key;
  says.doc = kinds.key_doc;
  says.kind = ParameterKind::choice;
  says.required = true;
  for (const Kinds::Kind& kind : kinds.kinds) says.choices.push_back(kind.name);
  std::vector<Value> defaults{Value()};
  for (const Kinds::Kind& kind : kinds.kinds) {
    const ParameterTable& own = kind.table();
    const std::vector<Value> own_defaults = own.defaults();
    for (std::size_t k = 0; k < own.parameters.size(); ++k) {
      if (all.find(own.parameters[k].name) != nullptr) continue;
      all.parameters.push_back(own.parameters[k]);
      all.parameters.back().required = is_required(kinds, own.parameters[k].name);
      defaults.push_back(own_defaults[k]);
    }
  }
  all.defaults = [defaults] { return defaults; };
  return all;
}

std::optional<std::size_t> read_kind(const Kinds& kinds, const ParameterTable& all, const Value& value,
                                     const Place& place, ParameterReader& reader) {
  if (value.object() == nullptr) {
    reader.fault(place, fmt::format("{} cannot be {}", kinds.element, value.description()),
                 fmt::format("an object with {}", fmt::join(all.names(), ", ")));
    return std::nullopt;
  }
  const Parameter& says = all.parameters.front();
  const Value* const given = value.find(kinds.key);
  if (given == nullptr) {
    reader.fault(place, fmt::format("{} has no '{}'", kinds.element, kinds.key), says.expectation());
    return std::nullopt;
  }
  return reader.choice(says, *given, Place(place, kinds.key));
}

Value table_detail::show_kind(const Kinds& kinds, std::size_t kind, const void* element) {
  Value shown = show_object(kinds.kinds[kind].table(), element);
  shown.object()->insert(shown.object()->begin(), {kinds.key, kinds.kinds[kind].name});
  return shown;
}

}  // namespace meristem
