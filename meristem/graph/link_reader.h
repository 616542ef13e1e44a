// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/name_index.h"
#include "meristem/graph/graph.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// Reads a document's links into its graph.
class LinkReader {
 public:
  /// The graph must have all its components. Faulty components have no type, and links to them cause no further fault.
  /// Graph and reader must outlive this object.
  LinkReader(Graph& graph, ParameterReader& reader);

  /// Reads a list of links. Each link is ["from", "to"] or an object.
  void read(const Value& links, const DocumentPath& path);

  /// Adds links to components that other components place by id. `components` is the path of the components in the
  /// document.
  void link_placed(const DocumentPath& components);

 private:
  void read_link(const Value& value, const DocumentPath& path);
  void read_kind(const Value& value, const DocumentPath& path, Link& link);
  ComponentIndex read_named_end(const Value& link, const char* name, const DocumentPath& path);
  ComponentIndex read_end(const Value& value, const DocumentPath& path);
  void check_crown(const DocumentPath& path, const Link& link);
  void check_placement(const Value& value, const DocumentPath& path, const Link& link, LinkKind kind);
  /// Returns the component at the beginning of a link, or null if it is unknown.
  const Prototype* parent_of(const Link& link) const;

  Graph& graph_;
  ParameterReader& reader_;
  /// Returns the component with an id, or kNoIndex.
  ComponentIndex component(std::string_view id) const;
  /// Returns the nearest id, for a message.
  std::string nearest_id(std::string_view id);
  std::size_t placed_count() const;

  NameIndex component_by_id_;
  std::vector<std::string> ids_;  // filled for the first message
};

}  // namespace meristem
