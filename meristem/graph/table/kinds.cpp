// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/table/kinds.h"

#include <algorithm>

#include <fmt/format.h>

#include "meristem/graph/table/reader.h"

namespace meristem {

namespace {

bool is_required(const ElementKinds& kinds, const std::string& row) {
  return std::all_of(kinds.kinds.begin(), kinds.kinds.end(), [&](const ElementKinds::Kind& kind) {
    const Parameter* const own = kind.table().find(row);
    return own != nullptr && own->required;
  });
}

}  // namespace

ParameterTable table_of_kinds(const ElementKinds& kinds) {
  ParameterTable all;
  all.name = kinds.element;
  all.doc = kinds.doc;
  Parameter& says = all.parameters.emplace_back();
  says.name = kinds.key;
  says.doc = kinds.key_doc;
  says.kind = ParameterKind::choice;
  says.required = true;
  for (const ElementKinds::Kind& kind : kinds.kinds) says.choices.push_back(kind.name);
  for (const ElementKinds::Kind& kind : kinds.kinds) {
    for (const Parameter& row : kind.table().parameters) {
      if (all.find(row.name) != nullptr) continue;
      all.parameters.push_back(row);
      all.parameters.back().required = is_required(kinds, row.name);
    }
  }
  return all;
}

std::optional<std::size_t> read_kind(const ElementKinds& kinds, const ParameterTable& all, const Value& value,
                                     const DocumentPath& path, ParameterReader& reader) {
  if (value.object() == nullptr) {
    reader.add_error(path, fmt::format("{} cannot be {}", kinds.element, value.description()),
                     fmt::format("an object with {}", fmt::join(all.names(), ", ")));
    return std::nullopt;
  }
  const Parameter& says = all.parameters.front();
  const Value* const given = value.find(kinds.key);
  if (given == nullptr) {
    reader.add_error(path, fmt::format("{} has no '{}'", kinds.element, kinds.key), says.expectation());
    return std::nullopt;
  }
  return reader.choice(says, *given, DocumentPath(path, kinds.key));
}

}  // namespace meristem
