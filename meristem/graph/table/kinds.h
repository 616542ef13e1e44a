// SPDX-License-Identifier: Apache-2.0
// Lists whose elements are structs of several kinds. Each kind has its own table. An element is an object; one member
// names its kind, and the kind's table reads all others, in any order.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "meristem/graph/table/parameter.h"

namespace meristem {

/// The kinds of a list's elements, in the order of the variant's alternatives.
struct ElementKinds {
  /// One kind of element.
  struct Kind {
    std::string name;                            ///< as documents write it
    const ParameterTable& (*table)() = nullptr;  ///< rows of the kind; not null
  };

  std::string element;      ///< name of an element of any kind in messages: "an operation"
  std::string doc;          ///< one sentence on the elements
  std::string key;          ///< name of the member that gives the kind
  std::string key_doc;      ///< one sentence on this member
  std::vector<Kind> kinds;  ///< at least one
};

/// Returns the rows of all kinds as one table, after the row of the kind. Used for the schema, for lists of parameters
/// and for messages; nothing is read with it. A row is required if every kind requires it.
ParameterTable table_of_kinds(const ElementKinds& kinds);

/// Returns the index of an element's kind, or nothing after a fault. `all` is the table of all kinds.
std::optional<std::size_t> read_kind(const ElementKinds& kinds, const ParameterTable& all, const Value& value,
                                     const DocumentPath& path, ParameterReader& reader);

}  // namespace meristem
