// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "meristem/graph/graph.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// Reads a document's links into its graph.
class LinkReader {
 public:
  /// The graph has all its components; faulty ones are without a type, so that links to them are no further fault. Both
  /// outlive the reader.
  LinkReader(Graph& graph, ParameterReader& reader);

  /// A list of links, each ["from", "to"] or an object.
  void read(const Value& links, const DocumentPath& path);

  /// Links to what components place themselves by its id; `components` is where they stand in the document.
  void link_placed(const DocumentPath& components);

 private:
  void read_link(const Value& value, const DocumentPath& path);
  void read_kind(const Value& value, const DocumentPath& path, Link& link);
  ComponentIndex read_named_end(const Value& link, const char* name, const DocumentPath& path);
  ComponentIndex read_end(const Value& value, const DocumentPath& path);
  void check_crown(const DocumentPath& path, const Link& link);
  void check_placement(const Value& value, const DocumentPath& path, const Link& link, LinkKind kind);
  /// Null where that is not known.
  const Prototype* parent_of(const Link& link) const;

  Graph& graph_;
  ParameterReader& reader_;
  std::unordered_map<std::string, ComponentIndex> component_by_id_;
  std::vector<std::string> ids_;
};

}  // namespace meristem
