// SPDX-License-Identifier: Apache-2.0
// Lists whose elements are structs of several kinds, each kind with a table of its own: an element is an object whose
// member says its kind, and all its other members are read by that kind's table, in whatever order they stand.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// The kinds of a list's elements, in the order of the variant's alternatives.
struct Kinds {
  /// One kind of element.
  struct Kind {
    std::string name;                            ///< as documents write it
    const ParameterTable& (*table)() = nullptr;  ///< rows of the kind; not null
  };

  std::string element;      ///< what messages call one of any kind: "an operation"
  std::string doc;          ///< one sentence on the elements
  std::string key;          ///< the member that says the kind
  std::string key_doc;      ///< one sentence on this member
  std::vector<Kind> kinds;  ///< at least one
};

/// The rows of all kinds as one table, after the one that says the kind: for the schema, for lists of parameters, and
/// for messages. A row is required there if every kind requires it; nothing is read by this table.
ParameterTable table_of_kinds(const Kinds& kinds);

/// Which kind an element is; nothing after a fault. `all` is the table of all kinds.
std::optional<std::size_t> read_kind(const Kinds& kinds, const ParameterTable& all, const Value& value,
                                     const DocumentPath& path, ParameterReader& reader);

}  // namespace meristem
